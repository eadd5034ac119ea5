"""Ragdolls, fluids, sand, cloth and ropes made of particles, simulated and drawn by OpenGL compute shaders.

    import knuckle
    simulation = knuckle.Simulation(knuckle.Scene.load("assets/scenes/hello.json"))
    simulation.step(60)
    simulation.positions()                 # float32 [n, 3], metres
    simulation.render(size=(640, 360))     # uint8 [360, 640, 4]

SI units, right-handed, +Y up. What is wrong with an input is told by InputError, in one line.
"""

from ._knuckle import (Actor, DeviceError, Film, InputError, RunError, Scene, Simulation, State, __version__,
                       compare, load_actor, voxelize)

__all__ = ["Actor", "DeviceError", "Film", "InputError", "RunError", "Scene", "Simulation", "State", "__version__",
           "compare", "load_actor", "voxelize"]
