/* corridor_game [--frames N] [--start T] [--size WxH] [--fps F] [--scale S] -o DIR: writes
 * DIR/0000.png and so on. See game.h for what is where. */
#include "game.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct Options {
    unsigned frames, width, height;
    double fps, scale, start;
    const char* folder;
} Options;

static GpDevice running;
static volatile sig_atomic_t interrupted;

static void onInterrupt(int signalNumber) {
    interrupted = 1;
    gpCancelRender(running);
    signal(signalNumber, SIG_DFL); /* a second one kills */
}

static int usage(const char* wrong, const char* word) {
    fprintf(stderr, "corridor_game: %s%s\n", wrong, word);
    fprintf(stderr,
            "usage: corridor_game [options] -o DIR\n"
            "  --frames N   1..100000; default: to the end of the walk of %.1f seconds\n"
            "  --start T    seconds into the walk that the first frame shows; default 0\n"
            "  --size WxH   pixels, each 1..16384; default 480x270\n"
            "  --fps F      frames a second, 0.1..1000; default 24\n"
            "  --scale S    rays along each side of the picture for a pixel, 0.5..1; default 1\n"
            "  -o DIR       a folder that is there; DIR/0000.png and so on are written\n",
            WALK_SECONDS);
    return 0;
}

/* A number and nothing behind it. */
static int number(const char* word, double low, double high, double* value) {
    char* end = NULL;
    *value = strtod(word, &end);
    return end != word && !*end && *value >= low && *value <= high;
}

static int parse(int argc, char** argv, Options* o) {
    double frames = 0;
    int i;
    for (i = 1; i < argc; i += 2) {
        const char *name = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
        int right, used = 0;
        if (!strcmp(name, "--help")) return usage("a walk through a level, path traced", "");
        if (!value) return usage("no value or unknown option: ", name);
        if (!strcmp(name, "--frames"))
            right = number(value, 1, 100000, &frames) && frames == (double)(unsigned)frames;
        else if (!strcmp(name, "--fps"))
            right = number(value, 0.1, 1000, &o->fps);
        else if (!strcmp(name, "--scale"))
            right = number(value, 0.5, 1, &o->scale);
        else if (!strcmp(name, "--start"))
            right = number(value, 0, WALK_SECONDS, &o->start);
        else if (!strcmp(name, "--size"))
            right = sscanf(value, "%5ux%5u%n", &o->width, &o->height, &used) == 2 && !value[used];
        else if (!strcmp(name, "-o"))
            o->folder = value, right = 1;
        else
            return usage("unknown option: ", name);
        if (!right) return usage("not a value that the option takes: ", value);
    }
    if (!o->folder) return usage("-o DIR is missing", "");
    o->frames = frames > 0 ? (unsigned)frames : (unsigned)((WALK_SECONDS - o->start) * o->fps);
    if (o->frames == 0) o->frames = 1;
    return 1;
}

/* Says what went wrong since the last call, if anything. */
static int failed(GpDevice device) {
    const char* message = "";
    const GpError error = gpGetError(device, &message);
    if (error && error != GP_ERROR_CANCELLED)
        fprintf(stderr, "corridor_game: %s: %s\n", gpErrorName(error), message);
    return error != GP_SUCCESS;
}

static void makeGame(Game* game) {
    game->scene = gpNewScene(game->device);
    game->im = gpNewImmediate(game->device);
    makeSurfaces(game);
    makeSprites(game);
    makeHud(game);
    makeSky(game);
    makeLevel(game);
    makeThings(game);
    makeLights(game);
    makeWeapon(game);
}

/* Everything that moves is put where it is at `seconds`, and handed over with what is drawn. */
static GpError renderGame(Game* game, GpFrame frame, double seconds, const Options* o) {
    const Player* p = &game->player;
    GpCameraDesc camera = {0};
    GpRenderOptions options = {0};
    walk(&game->player, seconds);
    moveThings(game, seconds);
    moveLights(game, seconds);
    moveWeapon(game, seconds);
    drawSky(game, frame, seconds);
    drawEffects(game, frame, seconds);
    drawHud(game, frame, seconds);
    camera.position[0] = p->eye.x, camera.position[1] = p->eye.y, camera.position[2] = p->eye.z;
    camera.target[0] = p->eye.x - p->back.x, camera.target[1] = p->eye.y - p->back.y;
    camera.target[2] = p->eye.z - p->back.z;
    camera.verticalFov = 58 * PI / 180;
    options.maxBounces = 2;
    options.realtime.renderScale = (float)o->scale;
    options.realtime.timeStep = (float)(1 / o->fps);
    options.realtime.lightReuse = GP_REUSE_BIASED;
    /* The eye gets used to the dark, but not wholly: torches do not turn night into day. */
    options.realtime.eyeAdaptation.seconds = 0.45f;
    options.realtime.eyeAdaptation.evMin = -4, options.realtime.eyeAdaptation.evMax = -0.3f;
    options.exposureEv = 1.25f;
    return gpRender(frame, game->scene, &camera, &options);
}

static int play(Game* game, const Options* o) {
    GpFrameDesc desc = {0};
    GpFrame frame;
    unsigned i;
    desc.width = o->width, desc.height = o->height, desc.mode = GP_MODE_REALTIME;
    frame = gpNewFrame(game->device, &desc);
    for (i = 0; i < o->frames && !interrupted; ++i) {
        char path[4096];
        if (renderGame(game, frame, o->start + i / o->fps, o)) break;
        snprintf(path, sizeof path, "%s/%04u.png", o->folder, i);
        gpSaveFrame(frame, path, NULL);
        if (failed(game->device)) return 1;
        fprintf(stderr, "\rframe %u of %u", i + 1, o->frames);
    }
    fprintf(stderr, "%s", i > 0 ? "\n" : "");
    if (failed(game->device) && !interrupted) return 1;
    if (interrupted) fprintf(stderr, "corridor_game: interrupted after %u frames\n", i);
    return interrupted ? 130 : 0;
}

int main(int argc, char** argv) {
    Options options = {0, 480, 270, 24, 1, 0, NULL};
    Game game = {0};
    int code;
    if (!parse(argc, argv, &options)) return argc == 2 && !strcmp(argv[1], "--help") ? 0 : 2;
    running = game.device = gpNewDevice(NULL);
    if (failed(NULL) || !game.device) return 1;
    signal(SIGINT, onInterrupt);
    game.width = options.width, game.height = options.height;
    makeGame(&game);
    code = failed(game.device) ? 1 : play(&game, &options);
    signal(SIGINT, SIG_IGN); /* nothing is left to cancel */
    gpReleaseDevice(game.device);
    return code;
}
