/* demo.h: the scene that 27 draws if it is given none: a table with one thing of each kind. The
 * same text is in scenes/demo.scene, to be changed; here it needs no file. */
#ifndef EFFECTS_DEMO_H
#define EFFECTS_DEMO_H

static const char demo_scene[] =
    "camera from 0 2.6 6.4 at 0 0.7 0 angle 38\n"
    "background 0.02 0.03 0.05\n"
    "material floor\n  Kd 0.7 0.68 0.62\n  illum 1\n"
    "polygon -6 0 4  6 0 4  6 0 -6  -6 0 -6\n"
    "material wall\n  Kd 0.35 0.45 0.6\n  illum 1\n"
    "polygon -6 0 -4  6 0 -4  6 6 -4  -6 6 -4\n"
    "material plaster\n  Kd 0.8 0.3 0.15\n  Ks 0.1\n  Ns 60\n  illum 2\n"
    "sphere -2.1 0.7 0  0.7\n"
    "material chrome\n  Kd 0.05\n  Ks 0.85\n  illum 3\n"
    "sphere -0.7 0.7 -0.6  0.7\n"
    "material brushed\n  Kd 0\n  Ks 0.8 0.6 0.3\n  Ns 80\n  illum 3\n"
    "cone 0.75 0 -0.4 0.6  0.75 1.4 -0.4 0.35\n"
    "material glass\n  Ni 1.5\n  Tf 1\n  absorb 0.5 0.1 0.3\n  illum 7\n"
    "sphere 2.1 0.7 0.3  0.7\n"
    "material lamp\n  Ke 2 1.85 1.7\n"
    "polygon -2.4 4.5 -1.6  2.4 4.5 -1.6  2.4 4.5 2.2  -2.4 4.5 2.2\n";

#endif
