"""Ragdolls, fluids, sand, cloth and ropes made of particles, simulated and drawn by OpenGL compute shaders.

    import knuckle
    simulation = knuckle.Simulation(knuckle.Scene.load("assets/scenes/hello.json"))
    simulation.step(60)
    simulation.positions()                 # float32 [n, 3], metres
    simulation.render(size=(640, 360))     # uint8 [360, 640, 4]

SI units, right-handed, +Y up. What is wrong with an input is told by InputError, in one line.
"""

try:
    from ._knuckle import (Actor, DeviceError, Film, InputError, RunError, Scene, Simulation, State, __version__,
                           compare, load_actor, voxelize)
except ModuleNotFoundError as error:
    if error.name != __name__ + "._knuckle":
        raise
    import sys
    raise ImportError("this package has no module for Python {}.{}; it is built for that of the system, which is "
                      "/usr/bin/python3".format(*sys.version_info)) from None

__all__ = ["Actor", "DeviceError", "Film", "InputError", "RunError", "Scene", "Simulation", "State", "__version__",
           "compare", "load_actor", "voxelize"]
