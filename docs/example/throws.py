"""A figure is thrown a hundred times: where it lies after two seconds. Writes throws.csv, throws.mp4 of the first throw
where there is ffmpeg, and throws.png where there is Matplotlib."""
import shutil
import sys

import numpy as np

import knuckle

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 100
scene = knuckle.Scene.load({
    "diameter": 0.06,
    "colliders": [{"type": "plane"}],
    "objects": [{"type": "actor", "name": "doll", "file": "assets/models/humanoid.glb", "position": [0, 0.5, 0]}],
    "camera": {"follow": "doll", "position": [0, 1.5, 5]},
})
simulation = knuckle.Simulation(scene)
start = simulation.save_state()
random = np.random.default_rng(1)


def throw(velocity, film=None):
    """Where the figure's mass centre is after two seconds, seen from above [m]."""
    simulation.load_state(start)
    simulation.set_velocity("doll", velocity)
    for _ in range(120):
        simulation.step(scene.steps_per_frame)
        if film:
            film.add(simulation.render(size=(640, 360)))
    bodies = simulation.bodies()
    return np.average(bodies["position"], axis=0, weights=bodies["mass"])[[0, 2]]


velocities = random.normal([2.5, 2.5, 0], 0.4, size=(COUNT, 3))
places = np.array([throw(velocity) for velocity in velocities])
np.savetxt("throws.csv", places, fmt="%.6f", delimiter=",", header="x,z", comments="")
print(f"{COUNT} throws: {places[:, 0].mean():.2f} m far, within {places[:, 0].std():.2f} m")
if shutil.which("ffmpeg"):
    with knuckle.Film("throws.mp4") as film:
        assert (throw(velocities[0], film) == places[0]).all()   # the same bits, filmed or not
try:
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit()
plt.scatter(*places.T)
plt.axis("equal")
plt.xlabel("x [m]")
plt.ylabel("z [m]")
plt.savefig("throws.png")
