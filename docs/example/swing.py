"""A pendulum whose motor is too weak to lift it is swung up: an environment as Gymnasium has them (reset, step), and a
rule that pumps energy into it. Prints how long that takes."""
import numpy as np

import knuckle

SCENE = {
    "diameter": 0.1,
    "objects": [
        {"type": "rigid", "shape": "box", "name": "rod", "size": [0.1, 0.9, 0.1], "position": [0, 1.0, 0]},
        {"type": "joint", "name": "axle", "kind": "hinge", "bodies": ["rod", "world"], "at": [0, 1.4, 0],
         "axis": [0, 0, 1], "motor": {"speed": 0, "torque": 0.001}},
    ],
}


class SwingUp:
    """Observations: angle from hanging down [rad], and its rate [rad/s]. Actions: torque, -1 to 1 of the greatest."""

    def __init__(self, greatest=8.0):
        self.scene = knuckle.Scene.load(SCENE)
        self.simulation = knuckle.Simulation(self.scene)
        self.start = self.simulation.save_state()
        self.greatest = greatest   # [N m]; holding it level would take 16

    def reset(self, seed=None):
        self.simulation.load_state(self.start)
        self.simulation.set_velocity("rod", [0, 0, 0])
        random = np.random.default_rng(seed)
        self.simulation.apply_impulse("rod", [random.uniform(0.2, 0.4), 0, 0])
        return self._observe(), {}

    def step(self, action):
        action = float(np.clip(action, -1, 1))
        # A motor that wants to be faster than it can gives all its torque.
        self.simulation.drive("axle", speed=30 * np.sign(action), torque=max(abs(action) * self.greatest, 1e-3))
        self.simulation.step(self.scene.steps_per_frame)
        angle, rate = observed = self._observe()
        return observed, -np.cos(angle), abs(angle) > 2.9, self.simulation.time > 30, {}

    def _observe(self):
        bodies = self.simulation.bodies()
        x, y = bodies["position"][0][:2] - [0, 1.4]
        return np.array([np.arctan2(x, -y), bodies["angular_velocity"][0][2]])


if __name__ == "__main__":
    world = SwingUp()
    (angle, rate), _ = world.reset(seed=1)
    up = timeout = False
    while not (up or timeout):
        (angle, rate), reward, up, timeout, _ = world.step(np.sign(rate))
    print(f"up after {world.simulation.time:.2f} s" if up else "never up")
