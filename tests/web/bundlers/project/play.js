// What a project does with the package: the hash of a second of water.
export function play(skvalp) {
    const scene = skvalp.scene('dam-break', { particles: 1000, settings: { 'fluid.law': 'clavet' } });
    const world = scene.world();
    for (let i = 0; i < 60; i++) {
        world.step();
    }
    const { hash } = world;
    world.destroy();
    scene.destroy();
    return hash;
}
