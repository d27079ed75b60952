/* What the library does natively, to be compared with what its WebAssembly module does: numbers are
 * printed bit by bit. Invariant: the same calls in the same order as in tests/web/reference.js.
 *   web_reference lab PARTICLES     the rows of all experiments
 *   web_reference files FILE        what becomes of the scenes packed in a file
 *   web_reference steps SCENE LAW PARTICLES THREADS INSTRUCTION-SET
 *                                   what frames cost, for scripts/bench-web.sh
 *   web_reference probe SCENE PARTICLES FRAMES X Y   pressure there, and what theory says of it
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "skvalp/experiments.h"
#include "skvalp/skvalp.h"

static void print_bits(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (value != value)
        printf(" nan");
    else
        printf(" %016" PRIx64, bits);
}

static int print_lab(const char *particles)
{
    skv_setting setting = {"particles", particles};
    skv_lab_options options = skv_default_lab_options();
    options.settings = &setting;
    options.setting_count = 1;
    options.threads = 1;
    for (int i = 0; skv_experiment_info(i) != NULL; i++) {
        skv_report *report;
        skv_error error;
        if (skv_experiment_run(i, &options, &report, &error) != SKV_OK) {
            printf("%s: %s\n", skv_experiment_info(i)->name, error.text);
            continue;
        }
        const skv_lab_row *row;
        for (int r = 0; (row = skv_report_row(report, r)) != NULL; r++) {
            printf("%s: %s [%s]", row->experiment, row->quantity, row->unit);
            print_bits(row->measured);
            print_bits(row->theory);
            print_bits(row->ratio);
            printf(" %s\n", row->pass ? "pass" : "fail");
        }
        skv_report_destroy(report);
    }
    return 0;
}

/* One line: the code, and the message or the world's hash. */
static void print_file(const void *data, size_t size, const char *format)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = 200;
    skv_scene *scene = NULL;
    skv_world *world = NULL;
    skv_error error;
    skv_result result = skv_scene_load_memory(data, size, format, "file", &options, &scene, &error);
    if (result == SKV_OK)
        result = skv_scene_create_world(scene, 1, &world, &error);
    if (result == SKV_OK)
        printf("0 %d %016" PRIx64 "\n", skv_world_particle_count(world), skv_world_hash(world));
    else
        printf("%d %s\n", (int)result, error.text);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
}

/* Files packed one after the other: "json" or "png ", 4 bytes of size, the lowest first, and the
 * bytes. */
static int print_files(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL)
        return 1;
    unsigned char head[8];
    while (fread(head, 1, sizeof head, file) == sizeof head) {
        size_t size =
            head[4] | (size_t)head[5] << 8 | (size_t)head[6] << 16 | (size_t)head[7] << 24;
        void *data = malloc(size + 1);
        if (data == NULL || fread(data, 1, size, file) != size)
            return 1;
        print_file(data, size, head[0] == 'p' ? "png" : "json");
        free(data);
    }
    fclose(file);
    return 0;
}

static double seconds_of(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static skv_instruction_set instruction_set(const char *name)
{
    for (int set = SKV_ISA_SCALAR; set <= SKV_ISA_WASM; set++) {
        const char *known = skv_instruction_set_name((skv_instruction_set)set);
        if (known != NULL && strcmp(known, name) == 0)
            return (skv_instruction_set)set;
    }
    return SKV_ISA_BEST;
}

static skv_result open_steps(char **argv, skv_world **world, skv_error *error)
{
    const skv_setting law = {"fluid.law", argv[1]};
    skv_scene_options options = skv_default_scene_options();
    options.particles = atoi(argv[2]);
    options.settings = &law;
    options.setting_count = 1;
    skv_scene *scene = NULL;
    skv_result result = skv_scene_load(argv[0], &options, &scene, error);
    if (result != SKV_OK)
        return result;
    skv_world_def def = skv_scene_world_def(scene);
    def.threads = atoi(argv[3]);
    def.instruction_set = instruction_set(argv[4]);
    def.sleep = false;
    result = skv_world_create(&def, world, error);
    if (result == SKV_OK)
        result = skv_scene_fill(scene, *world, error);
    skv_scene_destroy(scene);
    return result;
}

/* For each line that comes in, one frame: its substeps times particles, and what these took
 * together, in seconds: passed, and of processors. */
static int print_steps(char **argv)
{
    skv_world *world = NULL;
    skv_error error;
    if (open_steps(argv, &world, &error) != SKV_OK) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    while (getchar() != EOF) {
        double start = seconds_of(CLOCK_MONOTONIC), busy = seconds_of(CLOCK_PROCESS_CPUTIME_ID);
        skv_world_step(world, 1.0f / 60, NULL);
        double took = seconds_of(CLOCK_MONOTONIC) - start;
        busy = seconds_of(CLOCK_PROCESS_CPUTIME_ID) - busy;
        printf("%d %.9f %.9f\n",
               skv_world_particle_count(world) * skv_world_substeps_per_frame(world), took, busy);
        fflush(stdout);
    }
    skv_world_destroy(world);
    return 0;
}

/* What a lab reads after each frame, at last. */
static int print_probe(const char *name, int particles, int frames, double x, double y)
{
    skv_scene_options options = skv_default_scene_options();
    options.particles = particles;
    skv_scene *scene = NULL;
    skv_world *world = NULL;
    skv_lab *lab = NULL;
    skv_instrument id;
    skv_instrument_def def = skv_default_instrument_def(SKV_INSTRUMENT_PRESSURE);
    def.x0 = def.x1 = x;
    def.y0 = def.y1 = y;
    bool done = skv_scene_load(name, &options, &scene, NULL) == SKV_OK &&
                skv_scene_create_world(scene, 1, &world, NULL) == SKV_OK &&
                skv_lab_create(&lab, NULL) == SKV_OK && skv_lab_add(lab, &def, &id, NULL) == SKV_OK;
    for (int i = 0; done && i < frames; i++)
        done = skv_world_step(world, 1.0f / 60, NULL) == SKV_OK &&
               skv_lab_sample(lab, world, NULL) == SKV_OK;
    if (done) {
        print_bits(skv_lab_reading(lab, id, 0));
        print_bits(skv_lab_reading(lab, id, 1));
        printf("\n");
    }
    skv_lab_destroy(lab);
    skv_world_destroy(world);
    skv_scene_destroy(scene);
    return !done;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "lab") == 0)
        return print_lab(argv[2]);
    if (argc == 3 && strcmp(argv[1], "files") == 0)
        return print_files(argv[2]);
    if (argc == 7 && strcmp(argv[1], "steps") == 0)
        return print_steps(argv + 2);
    if (argc == 7 && strcmp(argv[1], "probe") == 0)
        return print_probe(argv[2], atoi(argv[3]), atoi(argv[4]), atof(argv[5]), atof(argv[6]));
    fprintf(stderr, "usage: web_reference lab PARTICLES | files FILE | steps SCENE LAW PARTICLES "
                    "THREADS INSTRUCTION-SET | probe SCENE PARTICLES FRAMES X Y\n");
    return 2;
}
