/* 27_files.h: texts as files in a directory of their own, and what reading them gives.
 *
 *   main: mkdtemp(directory), remove_directory()
 *   bool ok = read_scene("a.scene", &s, &f)    studio_read of a file there
 *   refused("a.mtl", text, scene, exit, "a.mtl:3: Kd", "0 to 1")
 *                                              the file `text` makes the reading of `scene` fail so
 *   seconds_at_most(120)                       of the processor: what never ends is ended, and a
 *                                              test that has to wait is not
 */
#ifndef FILES_27_H
#define FILES_27_H

#include "program.h"
#include "../chapters/27_effects/files/studio_read.h"
#include "check.h"
#include <sys/resource.h>

/* ---------------------------------------------------------------------------------------------- */

static inline void seconds_at_most(rlim_t most)
{
    setrlimit(RLIMIT_CPU, &(struct rlimit){most, most + 1});
}

static inline bool read_scene(const char *name, studio *s, failure *f)
{
    char path[256];
    *f = (failure){0, ""};
    snprintf(path, sizeof path, "%s", in_directory(name));
    return studio_read(path, NULL, s, f);
}

static inline void refused(const char *name, const char *text, const char *read, int exit_code,
                           const char *where, const char *allowed)
{
    studio s;
    failure f;
    put(name, text);
    bool ok = read_scene(read, &s, &f);
    check(!ok, "%s is read: %.60s", name, text);
    check(s.material == NULL && s.shapes == 0, "a scene that was refused is zeroed");
    if (ok) studio_free(&s);
    else check(f.exit_code == exit_code && strstr(f.text, where) && strstr(f.text, allowed),
               "exit %d, '%s'; expected %d, '%s', '%s'", f.exit_code, f.text, exit_code, where,
               allowed);
}

#endif
