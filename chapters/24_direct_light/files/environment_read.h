/* environment_read.h: an environment from a picture's file.
 *
 *   environment_read("sky.pfm", &e, &f)      .pfm: linear; .ppm: from sRGB
 */
#ifndef DIRECT_ENVIRONMENT_READ_H
#define DIRECT_ENVIRONMENT_READ_H

#include "../environment.h"

/* ---------------------------------------------------------------------------------------------- */

static inline bool environment_read(const char *path, environment *out, failure *f)
{
    image im = {0, 0, NULL};
    if (!image_read(path, &im, f)) return false;
    failure why;
    bool ok = environment_of_image(&im, out, &why);
    image_free(&im);
    return ok || failed(f, why.exit_code, "%.300s: %s", path, why.text);
}

#endif
