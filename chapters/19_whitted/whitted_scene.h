/* whitted_scene.h: what Whitted's ray tracing must know of a scene, beside where its surfaces are.
 *
 *   opaque surface (不透明)     kd, ks, ke of 18, and a mirror M on top: L = shade + M L(reflected)
 *   glass (透明介质)            bounds a body, filled with a medium; M and kt, usually white,
 *                               colour what Fresnel's equations share out:
 *                               L = R M L(reflected) + (1 - R) kt (n1/n2)^2 L(refracted)
 *
 * A material is asked for at each hit. `through` black makes glass a varnish: it reflects by its
 * refractive index, and nothing goes in.
 */
#ifndef WHITTED_SCENE_H
#define WHITTED_SCENE_H

#include "../18_shade/shade.h"
#include "media.h"

/* ---------------------------------------------------------------------------------------------- */

typedef struct {
    material base;    /* of it `mirror` is M, `through` kt; black: no refraction */
    uint32_t body;    /* glass: the body that it bounds [1..]; opaque: 0 */
    real shadow;      /* part of the light that shadow rays keep at each shape of it [0, 1] */
} whitted_look;

/* Is told of each ray: its parent's number (-1: the eye ray), what it is worth, and t of its hit,
 * infinity if none. Of a shadow ray: where it ends, and how much of the light arrives. Returns the
 * number of this ray. */
typedef struct whitted_log whitted_log;
struct whitted_log {
    int (*add)(whitted_log *log, ray_kind kind, int parent, int depth, ray r, real t, vec3 weight,
               real lit);
};

typedef struct {
    const light *lights;
    int n;
    /* May fill *room and return it, or return what it has. */
    const whitted_look *(*material_of)(const void *context, const trace_hit *x, const surface *s,
                                       whitted_look *room);
    const void *context;
    const medium *media;  /* media.h; [0]: around everything */
    vec3 background, ambient;
    vec3 (*sky)(const void *context, vec3 d);  /* along unit d; NULL: background */
    int depth;
    real least;
    bool apart, spend_all;
    real touch;           /* faces nearer to each other than this touch [scene units]: contact.h */
    whitted_log *log;     /* NULL, or to watch: lab/ray_tree.h */
} whitted;

enum { whitted_most_depth = 256 };

#endif
