/* ray_file.h: rays and hits in files, so that the search can be compared from outside.
 *
 *   RAYS   no header; a record is eight little-endian float32: ox oy oz tmin dx dy dz tmax
 *   HITS   no header; a record is a float32 t (+infinity: none) and a uint32 triangle (0xffffffff:
 *          none); occlusion: t = 0 and triangle 0 where occluded
 *
 *   ray *r = rays_read(path, &n, &f);          NULL: f says what is wrong; the caller frees
 *   hit *h = hits_read(path, n, &f);           n of them; u, v = 0; NULL as above
 *   bool rays_write(path, r, n, &f);
 *   bool hits_write(path, hit, n, any, &f);    hit[i].shape = no_shape where nothing was hit
 *
 *   file                                        answer
 *   cannot be read or written                   exit code 1
 *   empty, or its size no multiple of 32        exit code 2, with the size
 *   a record with NaN, or a direction 0         read as it is: such a ray hits nothing
 */
#ifndef MESH_RAY_FILE_H
#define MESH_RAY_FILE_H

#include "../../../common/file.h"
#include "../../01_ray/hit.h"

/* ---------------------------------------------------------------------------------------------- */

static inline uint32_t little_endian(const unsigned char *b)
{
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static inline real little_endian_real(const unsigned char *b)
{
    uint32_t bits = little_endian(b);
    float x;
    memcpy(&x, &bits, sizeof x);
    return (real)x;
}

/* Records of `size` bytes; the caller frees. */
static inline char *records_read(const char *path, size_t size, const char *what, size_t *n,
                                 failure *f)
{
    size_t bytes;
    char *all = file_read(path, &bytes, f);
    if (!all || (bytes > 0 && bytes % size == 0)) return *n = all ? bytes / size : 0, all;
    failed(f, 2, "%s: %zu bytes: a file of %s has %zu for each, and at least one", path, bytes, what,
           size);
    free(all);
    return NULL;
}

static inline ray *rays_read(const char *path, size_t *n, failure *f)
{
    char *bytes = records_read(path, 32, "rays", n, f);
    if (!bytes) return NULL;
    ray *r = allocate(*n, sizeof *r);
    for (size_t i = 0; i < *n; i++) {
        real x[8];
        for (size_t k = 0; k < 8; k++)
            x[k] = little_endian_real((const unsigned char *)bytes + 32 * i + 4 * k);
        r[i] = (ray){{x[0], x[1], x[2]}, x[3], {x[4], x[5], x[6]}, x[7]};
    }
    free(bytes);
    return r;
}

static inline hit *hits_read(const char *path, size_t n, failure *f)
{
    size_t there;
    char *bytes = records_read(path, 8, "hits", &there, f);
    if (bytes && there != n)
        failed(f, 2, "%s: %zu hits: %zu are expected, one a ray", path, there, n);
    hit *h = bytes && there == n ? allocate(n, sizeof *h) : NULL;
    for (size_t i = 0; h && i < n; i++) {
        const unsigned char *b = (const unsigned char *)bytes + 8 * i;
        h[i] = (hit){little_endian_real(b), 0, 0, little_endian(b + 4)};
    }
    free(bytes);
    return h;
}

static inline void put_little_endian(uint32_t word, FILE *out)
{
    for (int k = 0; k < 4; k++) putc((int)(word >> 8 * k & 255), out);
}

static inline void put_little_endian_real(real x, FILE *out)
{
    float t = (float)x;
    uint32_t word;
    memcpy(&word, &t, sizeof t);
    put_little_endian(word, out);
}

static inline bool rays_write(const char *path, const ray *r, size_t n, failure *f)
{
    file_writer w;
    if (!file_begin(&w, path, f)) return false;
    for (size_t i = 0; i < n; i++) {
        const real x[8] = {r[i].o.x, r[i].o.y, r[i].o.z, r[i].tmin,
                           r[i].d.x, r[i].d.y, r[i].d.z, r[i].tmax};
        for (int k = 0; k < 8; k++) put_little_endian_real(x[k], w.stream);
    }
    return file_commit(&w, f);
}

static inline bool hits_write(const char *path, const hit *h, size_t n, bool any, failure *f)
{
    file_writer w;
    if (!file_begin(&w, path, f)) return false;
    for (size_t i = 0; i < n; i++) {
        bool none = h[i].shape == no_shape;
        put_little_endian_real(none ? real_infinity : any ? 0 : h[i].t, w.stream);
        put_little_endian(none ? UINT32_MAX : any ? 0 : h[i].shape, w.stream);
    }
    return file_commit(&w, f);
}

#endif
