// The same as hello.c in C++: handles that free themselves, errors as exceptions.
//   c++ hello.cpp $(pkg-config --cflags --libs skvalp) -o hello
#include <skvalp/skvalp.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace {

struct destroy {
    void operator()(skv_world *world) const
    {
        skv_world_destroy(world);
    }
};
using world_handle = std::unique_ptr<skv_world, destroy>;

void check(skv_result result, const skv_error &error)
{
    if (result != SKV_OK)
        throw std::runtime_error(error.text);
}

world_handle make_world(const skv_world_def &def)
{
    skv_error error;
    skv_world *world = nullptr;
    check(skv_world_create(&def, &world, &error), error);
    return world_handle(world);
}

void run()
{
    skv_error error;
    skv_world_def def = skv_default_world_def();
    def.fluid.spacing = 0.02f;
    world_handle world = make_world(def);

    skv_fill_def column = skv_default_fill_def();
    column.x1 = 0.4f;
    column.y1 = 0.6f;
    check(skv_world_fill(world.get(), &column, nullptr, &error), error);
    for (int frame = 0; frame < 30; frame++)
        check(skv_world_step(world.get(), 1.0f / 60, &error), error);

    std::printf("skvalp %s: %d particles, centre of mass at %.3f m, hash %016llx\n", skv_version(),
                skv_world_particle_count(world.get()), skv_world_stats(world.get()).centre_y,
                static_cast<unsigned long long>(skv_world_hash(world.get())));
}

} // namespace

int main()
{
    try {
        run();
    } catch (const std::exception &failure) {
        std::fprintf(stderr, "hello: %s\n", failure.what());
        return 1;
    }
}
