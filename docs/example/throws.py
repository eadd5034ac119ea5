"""A figure is thrown a hundred times: where it lies after two seconds. Writes throws.csv, and throws.png where there is
Matplotlib."""
import sys

import numpy as np

import knuckle

COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 100
random = np.random.default_rng(1)
places = []
for throw in range(COUNT):
    velocity = [float(v) for v in random.normal([2.5, 2.5, 0], 0.4)]
    scene = knuckle.Scene.load({
        "diameter": 0.06,
        "colliders": [{"type": "plane"}],
        "objects": [{"type": "actor", "name": "doll", "file": "assets/models/humanoid.glb", "position": [0, 0.5, 0],
                     "velocity": velocity}],
    })
    simulation = knuckle.Simulation(scene)
    simulation.step(2 * 60 * scene.steps_per_frame)
    bodies = simulation.bodies()
    places.append(np.average(bodies["position"], axis=0, weights=bodies["mass"])[[0, 2]])
places = np.array(places)
np.savetxt("throws.csv", places, fmt="%.6f", delimiter=",", header="x,z", comments="")
print(f"{COUNT} throws: {places[:, 0].mean():.2f} m far, within {places[:, 0].std():.2f} m")
try:
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit()
plt.scatter(*places.T)
plt.axis("equal")
plt.savefig("throws.png")
