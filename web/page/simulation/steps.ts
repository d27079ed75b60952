// Steps: of how many particles scenes may begin with. Few and far apart: a device that is measured twice
// gets the same one.

/** For which the built-in scenes were made; those that say another number keep their share of it. */
export const standard = 3000;
export const steps = [500, 1000, 2000, 3000, 5000, 10000, 20000];
