#include "../chapters/12_kdtree/textbook.h"
#include "structure.h"
#include "../common/clock.h"
typedef struct { kdtree_options how; } x;
static kdtree_options options_now;
static void *build_now(const items *x, failure *f)
{
    kdtree *t = allocate(1, sizeof *t);
    if (kdtree_build(x, options_now, t, f)) return t;
    free(t);
    return NULL;
}
static bool hit_now(const void *s, ray r, hit *out) { return kdtree_hit(s, r, out); }
static bool occluded_now(const void *s, ray r) { return kdtree_occluded(s, r); }
static void destroy_now(void *s) { kdtree_free(s), free(s); }
static void count(const char*name, mesh m, kdtree_planar pl, kdtree_strategy st, size_t rays){
  items x=items_of_mesh(&m); failure f; kdtree t; kdtree_options o=kdtree_defaults; o.strategy=st;o.planar=pl; o.leaf=1; kdtree_build(&x,o,&t,&f);
  size_t w[4]={0};
  for(size_t i=0;i<rays;i++){ random_stream g=random_start(31,i,0); ray r=aimed(&m,&g,(int)(i%aimed_kinds),(vec3){0,0,0},1); if(r.tmin<0) continue; if(getenv("DY")) r=kd_dyadic_ray(&g);
    hit a=hit_none,b[4]={hit_none,hit_none,hit_none,hit_none}; bool ga=mesh_hit(&m,r,&a);
    w[0]+=!same(ga,a,kdtree_hit(&t,r,b),b[0]); w[1]+=!same(ga,a,kdtree_hit_textbook(&t,r,b+1),b[1]);w[2]+=!same(ga,a,kdtree_hit_naive_final(&t,r,b+2),b[2]);w[3]+=!same(ga,a,kdtree_hit_naive_strict(&t,r,b+3),b[3]);}
  printf("%s planar %d strat %d: padded %zu closed %zu final %zu strict %zu of %zu\n",name,pl,st,w[0],w[1],w[2],w[3],rays);
  kdtree_free(&t); mesh_free(&m);
}
int main(void)
{
    for(int s=0;s<3;s++) for(int p=0;p<3;p++){ count("floors",floors_mesh(4),p,s,3000); count("teapot",teapot_mesh(4),p,s,3000);  count("octa",octahedron_mesh(4),p,s,3000);}
    for (int s = 0; s < 3; s++) {
        options_now = kdtree_defaults; options_now.strategy = (kdtree_strategy)s;
        structure st = {"k-d tree", build_now, hit_now, occluded_now, destroy_now};
        double a = clock_seconds();
        structure_tests(&st, 300);
        printf("%d: %.2f s\n", s, clock_seconds() - a);
    }
    return check_report("12_kdtree");
}
