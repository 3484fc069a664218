/* ray_file.h: rays and hits in files, so that the search can be compared from outside.
 *
 *   RAYS   no header; a record is eight little-endian float32: ox oy oz tmin dx dy dz tmax
 *   HITS   no header; a record is a float32 t (+infinity: none) and a uint32 triangle (0xffffffff:
 *          none); occlusion: t = 0 and triangle 0 where occluded
 *
 *   ray *r = rays_read(path, &n, &f);          NULL: f says what is wrong; the caller frees
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

static inline ray *rays_read(const char *path, size_t *n, failure *f)
{
    size_t size;
    char *bytes = file_read(path, &size, f);
    if (!bytes) return NULL;
    if (size == 0 || size % 32 != 0) {
        failed(f, 2, "%s: %zu bytes: a file of rays has 32 for each, and at least one", path, size);
        free(bytes);
        return NULL;
    }
    *n = size / 32;
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

static inline bool hits_write(const char *path, const hit *h, size_t n, bool any, failure *f)
{
    file_writer w;
    if (!file_begin(&w, path, f)) return false;
    for (size_t i = 0; i < n; i++) {
        bool none = h[i].shape == no_shape;
        float t = none ? INFINITY : any ? 0 : (float)h[i].t;
        uint32_t word[2] = {0, none ? UINT32_MAX : any ? 0 : h[i].shape};
        memcpy(&word[0], &t, sizeof t);
        for (int k = 0; k < 8; k++) putc((int)(word[k / 4] >> 8 * (k % 4) & 255), w.stream);
    }
    return file_commit(&w, f);
}

#endif
