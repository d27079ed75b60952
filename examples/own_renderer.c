/* A renderer of your own: the particles drawn with SDL2, held with the mouse. Any toolkit will do:
 * the library hands out plain arrays and takes world coordinates.
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

/* Water is a square a particle, the lighter the higher its pressure. Returns how many. */
static int draw(SDL_Renderer *renderer, const skv_world *world, const skv_camera *camera)
{
    skv_particles particles = skv_world_particles(world);
    float size = (float)(skv_world_spacing(world) * camera->scale);
    SDL_SetRenderDrawColor(renderer, 16, 18, 24, 255);
    SDL_RenderClear(renderer);
    for (int i = 0; i < particles.count; i++) {
        float light = particles.pressure[i] / 5000;
        light = light < 0 ? 0 : light > 1 ? 1 : light;
        SDL_SetRenderDrawColor(renderer, (Uint8)(40 + 180 * light), (Uint8)(110 + 100 * light), 235,
                               255);
        SDL_FRect square = {(float)(camera->origin_x + particles.x[i] * camera->scale) - size / 2,
                            (float)(camera->origin_y - particles.y[i] * camera->scale) - size / 2,
                            size, size};
        SDL_RenderFillRectF(renderer, &square);
    }
    SDL_RenderPresent(renderer);
    return particles.count;
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
    skv_result result = make_world(&world);
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
        drawn = draw(renderer, world, &camera);
    }
    SDL_Log("%d particles drawn, %s", drawn, skv_result_text(result));

    skv_world_destroy(world);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
    SDL_Quit();
    return result == SKV_OK && drawn > 0 ? 0 : 1;
}
