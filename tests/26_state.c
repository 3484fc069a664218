/* Tests of 26: states that are cut, joined, resumed, damaged; error estimates. */
#include "check.h"
#include "program.h"
#include <sys/time.h>
#include "../common/output.h"
#include "../common/lab/t_test.h"
#include "../chapters/26_path_tracer/lab/command.h"

/* ---- how much is left ---- */

/* Samples 24 to 39, where a picture of 8 goes on to 72; of error and time nobody knows the end. */
static void test_part(void)
{
    passes_goal g = {.samples = 72}, timed = {.samples = 72, .seconds = 1},
                good = {.samples = 72, .error = 1};
    parallel_part p = passes_part(&g, 5, 8, 24, 40);
    check(p.start == 5 && p.before == 0.25 && p.share == 0.25, "a quarter, after a quarter");
    check(passes_part(&timed, 5, 8, 24, 40).start == 0, "of time: unknown");
    check(passes_part(&good, 5, 8, 24, 40).start == 0, "of an error: unknown");
}

/* ---- film and state ---- */

/* A scene, to be drawn on films of its own. */
static void place_of(shot *p, const char *name, int threads)
{
    const options o = {.seed = 4, .threads = threads};
    shot_of(p, &o, name, path_defaults, 1, 1);
}

static bool same(const film *a, const film *b)
{
    return a->width == b->width && a->height == b->height && a->ranges == b->ranges
        && memcmp(a->range, b->range, (size_t)a->ranges * sizeof *a->range) == 0
        && memcmp(a->half[0], b->half[0],
                  2 * (size_t)a->width * (size_t)a->height * sizeof *a->half[0]) == 0;
}

/* Two samples of one channel: what a tally cuts, or loses digits of, is told. */
static void test_doubt(void)
{
    static const struct { double sample; const char *says; } list[] = {
        {0, "black"}, {1e-30, "black"}, {2e-13, "black"}, {3e-13, NULL}, {1, NULL}, {1.7e13, NULL},
        {1.8e13, "1.8e+13"}, {1e30, "1.8e+13"}};
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        film m = film_new(1, 1);
        film_pixel p = {0};
        failure f;
        for (uint32_t i = 0; i < 2; i++)
            film_pixel_add(&p, i, (vec3){0, (real)list[k].sample, 0});
        film_gather(&m, 0, &p);
        check(film_cover(&m, 0, 2, &f), "2");
        const char *says = long_run_doubt(&m);
        check(list[k].says ? says && strstr(says, list[k].says) : !says, "%g: %s", list[k].sample,
              says ? says : "nothing");
        film_free(&m);
    }
}

/* 100 samples a second, and a tenth of a second left: ten more, not as many as there are. */
static void test_next(void)
{
    film m = film_new(1, 1);
    film_passes p = {.samples = 100, .seconds = 1};
    passes_goal g = {.samples = 1000, .seconds = 10};
    failure f;
    check_equal(passes_next(&p, &m, &g, clock_seconds()), 1, "the first");
    check(film_cover(&m, 0, 100, &f), "100");
    check_equal(passes_next(&p, &m, &g, clock_seconds()), 200, "there is time: twice as many");
    check_close(passes_next(&p, &m, &g, clock_seconds() - 9.6), 110, 3, "what is left");
    check_equal(passes_next(&p, &m, &g, clock_seconds() - 11), 100, "no time: none");
    film_free(&m);
}

/* Between passes: a signal that waits is heard, unless it is ignored. */
static void test_stopped(void)
{
    sigset_t both, before;
    sigemptyset(&both), sigaddset(&both, SIGINT), sigaddset(&both, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &both, &before);
    check(!passes_stopped(&both), "no signal: goes on");
    for (int k = 0; k < 2; k++) {
        int which = k ? SIGTERM : SIGINT;
        signal(which, SIG_DFL);  /* the background jobs of a shell begin with Ctrl-C ignored */
        raise(which);
        check(passes_stopped(&both) && parallel_stopped() == 128 + which, "%d: stops", which);
        signal(which, SIG_IGN);
        raise(which);
        check(!passes_stopped(&both), "%d, ignored: goes on", which);
        signal(which, SIG_IGN);  /* takes away what still waits */
        signal(which, SIG_DFL);
    }
    atomic_store(&parallel_stop, 0), atomic_store(&parallel_signal, 0);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

static void interrupt_soon(int signal) { (void)signal, raise(SIGINT); }

/* A pass of so many samples, with Ctrl-C after 20 ms of work; the time it takes, in seconds. */
static double stopped_pass(render_job *j, film *f, uint32_t samples)
{
    struct itimerval soon = {.it_value = {0, 20000}}, never = {.it_value = {0, 0}};
    double begun = clock_of(CLOCK_PROCESS_CPUTIME_ID);
    signal(SIGPROF, interrupt_soon), signal(SIGINT, SIG_DFL);
    setitimer(ITIMER_PROF, &soon, NULL);
    check(!passes_range(render_passes(j), f, 0, samples), "%u samples: stopped", (unsigned)samples);
    setitimer(ITIMER_PROF, &never, NULL);
    signal(SIGPROF, SIG_IGN);
    return clock_of(CLOCK_PROCESS_CPUTIME_ID) - begun;
}

/* A pass ends between two samples of some rows of a tile; those before are as in a whole pass. */
static void test_stopped_in_a_pixel(void)
{
    enum { side = 80, samples = 16 };  /* rows of a tile must end in time, and not all of them */
    shot s;
    place_of(&s, "spheres", 1);
    film whole = film_new(side, side), part = film_new(side, side), none = film_new(side, side);
    passes_range(render_passes(&s.j), &whole, 0, samples);
    stopped_pass(&s.j, &part, samples);
    double seconds = stopped_pass(&s.j, &none, 1u << 18);
    image due = film_picture(&whole), im = film_picture(&part);
    size_t kept = 0, wrong = 0;
    for (int i = 0; i < side * side; i++) {
        const float black[3] = {0, 0, 0}, *has = im.rgb + 3 * i;
        bool there = film_has_pending(&part, i % side, i / side);
        kept += there, wrong += memcmp(has, there ? due.rgb + 3 * i : black, sizeof black) != 0;
    }
    check(kept > 0 && kept < side * side, "pixels of a stopped pass: %zu", kept);
    check_equal(wrong, 0, "pixels that are neither whole nor black");
    check_at_most(seconds, 0.5, "seconds until a pass of 2^18 samples stops");
    check_equal(none.done[0], 0, "pixels that have them");
    image_free(&due), image_free(&im);
    film_free(&whole), film_free(&part), film_free(&none), shot_free(&s);
}

static void test_parts(void)
{
    const uint32_t cut[] = {0, 1, 7, 8, 20, 33};
    const int order[] = {3, 0, 4, 2, 1};
    shot one, three;
    failure f;
    place_of(&one, "spheres", 1), place_of(&three, "spheres", 3);
    film whole = film_new(21, 19), joined = film_new(21, 19), grown = film_new(21, 19), part;
    passes_range(render_passes(&one.j), &whole, 0, 33);
    double samples = 0, begun = clock_seconds();
    for (int i = 0; i < 5; i++) {
        int k = order[i];
        part = film_new(21, 19);
        passes_range(render_passes(&three.j), &part, cut[k], cut[k + 1]);
        check(film_join(&joined, &part, &f), "part %d joins", k);
        double sum = three.j.pass.samples, spent = three.j.pass.seconds;
        check(sum == (samples += cut[k + 1] - cut[k]), "samples of passes so far: %g", sum);
        check(spent > 0 && spent <= clock_seconds() - begun, "seconds in passes: %g", spent);
        if (i == 2) check(!film_join(&joined, &part, &f) && strstr(f.text, "twice"), "not twice");
        film_free(&part);
    }
    check(same(&whole, &joined), "five parts in any order, three threads: the same bits");
    passes_until(render_passes(&three.j), &grown, (passes_goal){.samples = 5});
    passes_until(render_passes(&three.j), &grown, (passes_goal){.samples = 33});
    check(same(&whole, &grown), "in passes, stopped and gone on: the same bits");
    part = film_new(20, 19);
    check(!film_join(&joined, &part, &f) && strstr(f.text, "20x19"), "another size does not fit");
    film_free(&part), film_free(&whole), film_free(&joined), film_free(&grown);
    shot_free(&one), shot_free(&three);
}

static void test_state(void)
{
    shot p;
    failure f;
    film m = film_new(9, 7), back;
    char settings[state_settings] = "scene x\nseed 4\n", empty[state_settings] = "";
    place_of(&p, "cornell", 1);
    passes_range(render_passes(&p.j), &m, 3, 6), passes_range(render_passes(&p.j), &m, 10, 12);
    const char *path = in_directory("s.state");
    check(state_write(path, &m, settings, &f), "written");
    check(state_read(path, &back, empty, &f) && same(&m, &back), "and read: the same");
    check_text(empty, settings, "its settings");
    film_free(&back);
    check(!state_read(path, &back, (char[state_settings]){"scene x\nseed 5\n"}, &f)
          && f.exit_code == 2 && strstr(f.text, "'seed 4', not 'seed 5'"),
          "another seed: %s", f.text);
    check(!state_read(in_directory("none"), &back, empty, &f) && f.exit_code == 1, "no such file");
    size_t n;
    char *text = file_read(path, &n, &f), *damaged = allocate(n + 1, 1);
    for (size_t k = 0; k < 400; k++) {  /* a bit here, an end there */
        size_t at = k * 977 % n, length = k % 2 ? n : at;
        memcpy(damaged, text, n + 1);
        if (k % 2) damaged[at] = (char)(damaged[at] ^ 1 << k % 8);
        char of[state_settings] = "";
        bool read = state_parse("x", damaged, length, &back, of, &f);
        check(!read && f.exit_code == 2, "a damaged state is refused: %zu", k);
        if (read || back.width) film_free(&back);
    }
    /* The right checksum, but sizes and ranges of nonsense. */
    const char *header[] = {"size 9x7\nsamples 3:6 5:9\n\n", "size 0x7\nsamples 3:6\n\n",
                            "size 9x9\nsamples 3:6\n\n", "size 99999x7\nsamples 3:6\n\n",
                            "size 9x7\nsamples 6:3\n\n", "size 9x7\n\n",
                            "size 9x7\nsamples 1:\n\n",
                            "size 9x16384\nsamples 3:6\n\n",
                            "size 16384x16384\nsamples 3:6\n\n"};  /* a film of 26 GB */
    for (int k = 0; k < 9; k++) {
        char *made = allocate(n + 100, 1), of[state_settings] = "";
        size_t l = (size_t)sprintf(made, "%sscene x\n%s", state_magic, header[k]);
        l += 96 * 63;
        state_word((uint8_t *)made + l, state_hash(state_hash_start, made, l));
        back = (film){.width = 0};
        check(!state_parse("x", made, l + 8, &back, of, &f) && f.exit_code == 2
              && strstr(f.text, "its header is damaged"), "header %d: %s", k, f.text);
        film_free(&back), free(made);
    }
    free(text), free(damaged), film_free(&m), shot_free(&p);
}

/* ---- the program ---- */

static int go(const char *arguments) { return run("26_path_tracer", arguments); }

/* A fin that stands on the floor, as the file of a world in which y, or z, points up. */
#define FIN_FACES "f 1//1 2//1 3//2\nf 2//1 4//2 3//1\n"
#define FIN "v -1 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 -1\nvn 0 1 2\nvn 1 1 0\n" FIN_FACES
#define FIN_Z "v -1 0 0\nv 1 0 0\nv 0 0 2\nv 0 1 0\nvn 0 -2 1\nvn 1 0 1\n" FIN_FACES

/* Five triangles: of no material, of one that nobody describes, and of three that two libraries
 * do, one of them both. */
#define MODEL "mtllib a.mtl b.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nusemtl nobody\nf 1 2 3\n"   \
    "usemtl red\nf 1 2 3\nusemtl lamp\nf 1 2 3\nusemtl loud\nf 1 2 3\nusemtl red\nf 1 2 3\n"
#define RED "newmtl unused\nKd 1 1 1\nKs 1 1 1\nnewmtl red\nKd 0.5 0.25 0\n"
#define OTHERS "newmtl red\nKd 0 0 1\nnewmtl lamp\nKe 3 2 1\nnewmtl loud\nKd 2 1 0\n"

static void test_materials(void)
{
    static const struct { double kd[3]; double ke; } is[6] = {
        {{0.72, 0.7, 0.66}, 0}, {{0.72, 0.7, 0.66}, 0}, {{0.5, 0.25, 0}, 0}, {{0, 0, 0}, 3},
        {{1, 0.5, 0}, 0}, {{0.5, 0.25, 0}, 0}};
#define model "@m.obj --size 8x6 "
#define once model "--samples 1 --out @p.pfm"
    static const struct {  /* a file that is written anew, or removed; then a run; what it says */
        const char *file, *text, *arguments;
        int status;
        const char *what, *says[2], *quiet;
    } list[] = {
        {NULL, NULL, model "--samples 2 --save @m.state --out @p.pfm", 0, "a state",
         {"m.obj: material 'nobody' is nowhere described: grey\n"}, "only Kd"},
        {"a.mtl", RED "Ks 1 1 1\n", model "--samples 3 --resume @m.state --out @p.pfm", 2,
         "another library: another picture", {NULL}, NULL},
        {NULL, NULL, once, 0, "shiny", {"only Kd and Ke are used here"}, NULL},
        {NULL, NULL, model "--samples 1 --save @a.mtl --out @p.pfm", 2,
         "no state instead of a library", {NULL}, NULL},
        {"a.mtl", "newmtl red\nKd red\n", once, 2, "a broken library",
         {"a.mtl:2: Kd: not a number"}, NULL},
        {"a.mtl", NULL, once, 0, "a library that is not there, and one that might have it",
         {"mtllib a.mtl: no such file", "material 'nobody' is nowhere described"}, NULL},
        {"b.mtl", NULL, once, 0, "no library: that is said already", {NULL}, "nowhere"},
        {"m.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl None\nf 1 2 3\nusemtl\nf 1 2 3\nusemtl b\n"
         "f 1 2 3\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl (null)\nf 1 2 3\n", once, 0,
         "none is asked for", {"material 'a' is nowhere described: grey (and 1 more)\n"}, NULL}};
    showcase c;
    failure f;
    put("m.obj", MODEL), put("a.mtl", RED), put("b.mtl", OTHERS);
    if (!showcase_of_obj(in_directory("m.obj"), false, 1, &c, &f)) fail(f);
    for (size_t i = 0; i < 6; i++) {
        const material *m = &c.s.material[c.s.of_triangle[i]];
        vec3 wo = {0, 0, 1}, value = brdf_value_local(&c.s.f[m - c.s.material], wo, wo);
        for (int k = 0; k < 3; k++)
            check_close((double)vaxis(value, k), is[i].kd[k] / (double)pi, 4 * real_epsilon,
                        "triangle %zu, Kd %d", i, k);
        check_equal((double)m->ke.x, is[i].ke, "triangle %zu: Ke", i);
        check((c.s.emitter_of[i] != lit_dark) == (is[i].ke > 0), "a light, if it shines");
    }
    check(c.s.emitters == 1 && fabs(c.s.emitter->area - 1) <= 4 * real_epsilon,
          "one emitter, of the triangle's area");
    check_equal(c.s.materials, 5, "grey, three of the model, the floor: a material each");
    check(c.s.emitter->both, "which shines from both sides");
    showcase_free(&c);
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        if (list[k].text) put(list[k].file, list[k].text);
        else if (list[k].file) remove(in_directory(list[k].file));
        check_equal(go(list[k].arguments), list[k].status, "%s", list[k].what);
        for (int i = 0; i < 2 && list[k].says[i]; i++)
            check(printed("err", list[k].says[i]), "%s: %s", list[k].what, list[k].says[i]);
        if (list[k].quiet)
            check(!printed("err", list[k].quiet), "%s: no %s", list[k].what, list[k].quiet);
    }
}

/* One run, a part of it resumed, and three ranges merged are the same bytes; --up z is the model
 * turned, and its states are no others' states; what is refused says why. */
static void test_program(void)
{
#define small "--size 24x18 --scene spheres "
#define tiny "@z.obj --size 24x18 "
    static const struct { int status; const char *arguments, *says; } list[] = {
        {0, small "--samples 12 --save @all.state --out @all.pfm", NULL},
        {0, small "--samples 5 --save @part.state --out @p.pfm", NULL},
        {0, small "--samples 12 --resume @part.state --save @more.state --out @more.pfm", NULL},
        {0, small "--range 0:3 --save @a.state --out @p.pfm", NULL},
        {0, small "--range 8:12 --save @c.state --out @p.pfm", NULL},
        {0, small "--range 3:8 --save @b.state --out @p.pfm", NULL},
        {0, "--merge @c.state @a.state @b.state --save @m.state --out @m.pfm", NULL},
        {2, "--merge @a.state @a.state --quick", "nothing counts twice"},
        {2, "--merge @a.state --clamp 1 --out @p.pfm", NULL},
        {2, "--merge @a.state --environment x.pfm --out @p.pfm", NULL},
        {2, small "--seed 9 --samples 12 --resume @part.state --out @p.pfm",
         "'seed 1', not 'seed 9'"},
        {2, small "--samples 12 --resume @c.state --out @p.pfm", NULL},  /* not from 0 */
        {2, small "--size 23x18 --samples 12 --resume @part.state --out @p.pfm",
         "24x18 pixels, not"},
        {2, small "--size 24x17 --samples 12 --resume @part.state --out @p.pfm",
         "24x18 pixels, not"},
        {2, small "--range 5:3 --out @p.pfm", NULL}, {2, "--scene nowhere --out @p.pfm", NULL},
        {0, small "--error 0.5 --out @p.pfm", NULL},
        {0, "@w.obj --size 24x18 --samples 2 --out @p.pfm", "warning: samples brighter than"},
        {2, small "--samples 900000 --resume @part.state --csv @part.state",
         "this run has read it"},  /* before any work */
        {0, "--size 24x18 chapters/07_mesh/scenes/teapot.obj --samples 1 --out @p.pfm", NULL},
        {0, "@y.obj --size 24x18 --samples 4 --out @y.pfm", NULL},
        {0, tiny "--up z --range 0:4 --save @z.state --out @z.pfm", NULL},
        {0, tiny "--samples 4 --out @lies.pfm", NULL},
        {2, tiny "--samples 5 --resume @z.state --out @p.pfm",
         "'scene obj, z up', not 'scene obj'"},
        {2, "@z.obj --up x --quick", NULL}, {2, "--up z", NULL},  /* of no mesh */
        {2, "--pixel 640,0", "--pixel 640,0: allowed are X,Y"},
        {2, "--pixel 3,3 --time 1", NULL}, {2, "--pixel 3,3 --scene teapot", NULL}};
    static const char *const same_bytes[][2] = {{"all.state", "more.state"},
        {"all.pfm", "more.pfm"}, {"all.state", "m.state"}, {"all.pfm", "m.pfm"},
        {"y.pfm", "z.pfm"}};
    put("y.obj", FIN), put("z.obj", FIN_Z);
    put("w.mtl", "newmtl lamp\nKe 1e30 0 0\n");
    put("w.obj", "mtllib w.mtl\nusemtl lamp\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        check_equal(go(list[k].arguments), list[k].status, "%s", list[k].arguments);
        if (list[k].says)
            check(printed("err", list[k].says), "%s: says so", list[k].arguments);
    }
    for (size_t k = 0; k < sizeof same_bytes / sizeof *same_bytes; k++)
        check(equal_files(same_bytes[k][0], same_bytes[k][1]), "%s and %s: the same bytes",
              same_bytes[k][0], same_bytes[k][1]);
    check(!equal_files("z.pfm", "lies.pfm"), "without --up z: another picture");
}

/* A state knows a model by its bytes; a pipe has them only once, and a picture needs them, too. */
static void test_pipes(void)
{
    check_equal(shell("mkfifo @pipe; cat chapters/07_mesh/scenes/teapot.obj >@pipe &"), 0,
                "filled");
    alarm(300);  /* who opened the pipe twice would wait for ever */
    check_equal(go("@pipe --size 8x6 --samples 1 --out @p.pfm"), 0, "a model");
    alarm(0);
    check_equal(go("@pipe --size 8x6 --samples 1 --save @p.state"), 2, "no state of it");
    check(printed("err", "--save and the like want a file, no pipe"), "and says why");
}

/* ---- the error estimate is what it says ---- */

static double distance(const film *a, const image *reference)
{
    image im = film_picture(a);
    double e = image_compare(&im, reference).rmse;
    image_free(&im);
    return e;
}

static void test_error(void)
{
    enum { side = 20 };
    shot p;
    place_of(&p, "cornell", 0);  /* seen so that the light's edges, most of its noise, are not */
    p.j.eye = showcase_eye((vec3){278, 200, -150}, (vec3){278, 80, 559}, 45, 1);
    film all = film_new(side, side);
    uint32_t most = 300 + (uint32_t)check_count(1200);
    p.j.seed = 99;
    passes_range(render_passes(&p.j), &all, 0, most);
    image reference = film_picture(&all);
    double rest = film_error(&all), true2 = 0, said2 = 0;
    int runs = 12;
    for (int k = 0; k < runs; k++) {
        film m = film_new(side, side);
        p.j.seed = (uint64_t)k;
        passes_range(render_passes(&p.j), &m, 0, 24);
        double e = distance(&m, &reference), said = film_error(&m);
        true2 += e * e / runs, said2 += said * said / runs;
        film_free(&m);
    }
    /* The reference's own error is in true2. 12 x 1200 numbers of chance, squared, and those of a
     * pixel are alike: off by sqrt(2 / 4800) = 2 % each, twice that for their tails; times 5. */
    check_close(said2 / (true2 - rest * rest), 1, 0.2, "estimated by true mean square error");
    for (int k = 0; k < 3; k++) {
        film m = film_new(side, side);
        double wanted = k == 0 ? 0.02 : k == 1 ? 0.01 : 0.007;
        p.j.seed = 50 + (uint64_t)k;
        passes_until(render_passes(&p.j), &m, (passes_goal){.error = wanted});
        double e = distance(&m, &reference);
        check_at_most(film_error(&m), wanted, "stopped where the estimate is");
        /* One picture: 3 x 400 numbers: 8 % of the square with tails; times 5: 1.2. */
        check_at_most(e, 1.2 * sqrt(wanted * wanted + rest * rest), "asked for %g", wanted);
        check_at_least(film_samples(&m), 16, "not before 16 samples");
        film_free(&m);
    }
    image_free(&reference), film_free(&all), shot_free(&p);
}

/* ---- environment, dielectric: closed forms ---- */

/* How often it goes through: 1 - R, R in closed form. */
static void through_often(real n2, real cosine, double R)
{
    random_stream s = random_start(26, 5, (uint64_t)(n2 * 100));
    estimate e = {0};
    vec3 wo = {sqrt(1 - cosine * cosine), 0, cosine};
    for (size_t i = 0; i < check_count(40000); i++) {
        bool through;
        (void)dielectric_scatter((vec3){0, 0, 1}, wo, 1, n2, random_next(&s), &through);
        e = estimate_add(e, through);
    }
    check_at_least(t_test(e, 1 - R, 1e-6), 1e-7, "n = %g, cos %g: %g through, not %g", (double)n2,
                   (double)cosine, e.mean, 1 - R);
}

static void test_dielectric(void)
{
    real rs = (real)1.25 / (real)3.25;
    through_often(1.5, 1, 0.04), through_often(3, 1, 0.25), through_often(1, 0.3, 0);
    through_often(1.5, 1 / sqrt((real)3.25), (double)(rs * rs / 2));  /* Brewster's angle */
    through_often(0.5, 0.5, 1);  /* total */
    check_close(dielectric_squeeze(3, 2) * dielectric_squeeze(2, 3), 1, 4 * real_epsilon,
                "there and back");
}

static void test_environment(void)
{
    image im = image_new(12, 6);
    environment e;
    failure f;
    random_stream s = random_start(26, 4, 1);
    for (int i = 0; i < 72; i++)
        for (int k = 0; k < 3; k++)
            im.rgb[3 * i + k] = i % 5 == 0 ? 0 : (float)random_next(&s) * (i % 7 ? 1.f : 30.f);
    check(environment_of_image(&im, &e, &f), "built");
    estimate omega = {0}, zz = {0};
    size_t wrong = 0;
    real covered = 0;
    for (int j = 0; j < 6; j++) covered += 12 * environment_omega(&e, j);
    check_close(covered, 4 * pi, 64 * real_epsilon, "all texels make the sphere");
    double lit = 0, lit_zz = 0;
    for (int i = 0; i < 72; i++) {
        double top = cos((double)pi * (i / 12) / 6), bottom = cos((double)pi * (i / 12 + 1) / 6);
        lit += i % 5 ? (double)environment_omega(&e, i / 12) : 0;
        double cubes = top * top * top - bottom * bottom * bottom;
        lit_zz += i % 5 ? 2 * (double)pi / 12 * cubes / 3 : 0;
    }
    for (size_t i = 0; i < check_count(200000); i++) {
        vec3 d, L;
        real pdf;
        point2 u = {random_next(&s), random_next(&s)};
        environment_sample(&e, u, &d, &pdf, &L);
        vec3 at = environment_radiance(&e, d);
        real again = environment_pdf(&e, d);
        wrong += !(fabs(again / pdf - 1) < 64 * real_epsilon) || at.x != L.x;  /* edges of texels */
        wrong += fabs(vlength(d) - 1) > 8 * real_epsilon;
        omega = estimate_add(omega, (double)(1 / pdf));
        zz = estimate_add(zz, (double)(d.y * d.y / pdf));
    }
    check_at_most((double)wrong, (double)check_count(200000) * (real_is_float ? 1e-4 : 1e-5),
                  "sample and lookup");
    check_at_least(t_test(omega, lit, 1e-5 * lit), 1e-7, "E[1/pdf] is the solid angle that shines");
    check_at_least(t_test(zz, lit_zz, 1e-5 * lit), 1e-7, "even in cos theta, not in theta");
    environment_free(&e);
    im.rgb[5] = -1;
    check(!environment_of_image(&im, &e, &f) && f.exit_code == 2, "a negative radiance");
    im.rgb[5] = NAN;
    check(!environment_of_image(&im, &e, &f), "a NaN");
    memset(im.rgb, 0, 72 * 3 * sizeof *im.rgb);
    check(!environment_of_image(&im, &e, &f), "black");
    check(image_write(in_directory("black.pfm"), &im, &f), "%s", f.text);
    check(!environment_read(in_directory("black.pfm"), &e, &f) && f.exit_code == 2
          && strstr(f.text, "black.pfm: the environment has"), "the file is named: %s", f.text);
    image_free(&im);
}

static void test_pixel(void)
{
    for (int k = 0; k < 6; k++) {
        char arguments[80];
        snprintf(arguments, sizeof arguments, "--pixel %d,%d --scene %s --seed %d", 40 + 40 * k,
                 250 - 20 * k, ((const char *[]){"cornell", "spheres", "metal"})[k % 3], k);
        check_equal(run("26_path_tracer", arguments), 0, "%s", arguments);
        check(printed("out", "\nx0 = (") && printed("out", "(26.2)") && printed("out", "(26.5)\n"),
              "lines with their equations");
    }
}

int main(void)
{
    if (!mkdtemp(directory)) return 1;
    test_part();
    test_doubt();
    test_next();
    test_stopped();
    test_stopped_in_a_pixel();
    test_parts();
    test_state();
    test_dielectric();
    test_environment();
    test_error();
    if (go("--help") == 0) {  /* a pipe that no program opens would wait for ever */
        test_program(), test_materials();
        test_pipes();
        test_pixel();
    } else check(false, "26_path_tracer: the program is not built (make)");
    remove_directory();
    return check_report("26_state");
}
