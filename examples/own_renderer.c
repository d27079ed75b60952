/* A renderer of your own: particles and the outline of the water drawn with SDL2, held with the
 * mouse. Any toolkit will do: the library hands out plain arrays in metres.
 *   own_renderer [FRAMES]   ends after so many frames; without, when the window is closed */
#include <skvalp/skvalp.h>

#include <SDL.h>
#include <stdlib.h>

enum { WIDTH = 1280, HEIGHT = 720 };

/* The hand that holds the fluid where the mouse is down. */
static skv_result hold(skv_world *world, const skv_camera *camera)
{
    int px, py;
    if (!(SDL_GetMouseState(&px, &py) & SDL_BUTTON(SDL_BUTTON_LEFT)))
        return skv_world_set_hands(world, NULL, 0, NULL);
    double x, y;
    skv_camera_to_world(camera, px, py, &x, &y);
    skv_hand hand = skv_default_hand();
    hand.x = (float)x;
    hand.y = (float)y;
    return skv_world_set_hands(world, &hand, 1, NULL);
}

static SDL_FPoint in_view(const skv_camera *camera, float x, float y)
{
    return (SDL_FPoint){(float)(camera->origin_x + x * camera->scale),
                        (float)(camera->origin_y - y * camera->scale)};
}

/* Water is a square a particle. */
static void draw_particles(SDL_Renderer *renderer, const skv_world *world, const skv_camera *camera)
{
    skv_particles particles = skv_world_particles(world);
    float size = (float)(skv_world_spacing(world) * camera->scale);
    SDL_SetRenderDrawColor(renderer, 40, 110, 200, 255);
    for (int i = 0; i < particles.count; i++) {
        SDL_FPoint p = in_view(camera, particles.x[i], particles.y[i]);
        SDL_RenderFillRectF(renderer, &(SDL_FRect){p.x - size / 2, p.y - size / 2, size, size});
    }
}

/* The surface is lines; returns how many points they have. */
static int draw_surface(SDL_Renderer *renderer, const skv_surface *surface,
                        const skv_camera *camera)
{
    int points = 0;
    SDL_SetRenderDrawColor(renderer, 255, 255, 255, 255);
    for (int line = 0; line < skv_surface_line_count(surface); line++) {
        int count;
        bool closed;
        const skv_point *point = skv_surface_line(surface, line, &count, &closed);
        for (int i = closed ? 0 : 1; i < count; i++) {
            const skv_point *before = &point[i > 0 ? i - 1 : count - 1];
            SDL_FPoint a = in_view(camera, before->x, before->y);
            SDL_FPoint b = in_view(camera, point[i].x, point[i].y);
            SDL_RenderDrawLineF(renderer, a.x, a.y, b.x, b.y);
        }
        points += count;
    }
    return points;
}

static skv_result make_world(skv_world **world)
{
    skv_world_def def = skv_default_world_def();
    skv_fill_def column = skv_default_fill_def();
    column.x1 = 0.5f;
    column.y1 = 0.7f;
    skv_result result = skv_world_create(&def, world, NULL);
    return result == SKV_OK ? skv_world_fill(*world, &column, NULL, NULL) : result;
}

int main(int argc, char **argv)
{
    long frames = argc > 1 ? strtol(argv[1], NULL, 10) : -1;
    SDL_Window *window;
    SDL_Renderer *renderer;
    if (SDL_Init(SDL_INIT_VIDEO) ||
        SDL_CreateWindowAndRenderer(WIDTH, HEIGHT, 0, &window, &renderer)) {
        SDL_Log("own_renderer: %s", SDL_GetError());
        return 1;
    }

    skv_world *world = NULL;
    skv_survey *survey = NULL;
    skv_surface *surface = NULL;
    skv_result result = make_world(&world);
    if (result == SKV_OK)
        result = skv_survey_create(&survey, NULL);
    if (result == SKV_OK)
        result = skv_surface_create(&surface, NULL);
    skv_camera camera = {0};
    if (world)
        camera = skv_camera_fit(WIDTH, HEIGHT, skv_terrain_width(skv_world_terrain(world)),
                                skv_terrain_height(skv_world_terrain(world)));
    int drawn = 0;
    for (bool open = true; open && frames != 0 && result == SKV_OK; frames--) {
        for (SDL_Event event; SDL_PollEvent(&event);)
            open = open && event.type != SDL_QUIT;
        result = hold(world, &camera);
        if (result == SKV_OK)
            result = skv_world_step(world, 1.0f / 60, NULL);
        if (result == SKV_OK)
            result = skv_survey_take(survey, world, NULL);
        if (result == SKV_OK)
            result = skv_surface_find(surface, survey, NULL, NULL);
        SDL_SetRenderDrawColor(renderer, 16, 18, 24, 255);
        SDL_RenderClear(renderer);
        draw_particles(renderer, world, &camera);
        drawn = draw_surface(renderer, surface, &camera);
        SDL_RenderPresent(renderer);
    }
    SDL_Log("%d points of the surface drawn, %s", drawn, skv_result_text(result));

    skv_surface_destroy(surface);
    skv_survey_destroy(survey);
    skv_world_destroy(world);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return result == SKV_OK && drawn > 0 ? 0 : 1;
}
