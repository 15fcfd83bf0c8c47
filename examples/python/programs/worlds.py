# SPDX-License-Identifier: BSD-3-Clause
"""The data of the programs in this folder, as NumPy arrays. The programs for boxplus, GTSAM and g2o get the same data."""

from types import SimpleNamespace

import numpy as np

#: The standard deviations of the motions: meters, meters, radians.
SIGMAS = np.array([0.05, 0.05, 0.01])


def relative(a, b):
    """The poses or points b (n, 3 or 2) of the plane relative to the poses a (n, 3)."""
    d, c, s = b[:, :2] - a[:, :2], np.cos(a[:, 2]), np.sin(a[:, 2])
    moved = np.c_[c * d[:, 0] + s * d[:, 1], c * d[:, 1] - s * d[:, 0]]
    return np.c_[moved, wrapped(b[:, 2:] - a[:, 2:])] if b.shape[1] == 3 else moved


def wrapped(angle):
    return angle - 2 * np.pi * np.rint(angle / (2 * np.pi))


def chained(steps):
    """The poses that the motions lead to, from the origin."""
    poses = np.zeros((len(steps) + 1, 3))
    for k, (x, y, theta) in enumerate(steps):
        c, s = np.cos(poses[k, 2]), np.sin(poses[k, 2])
        poses[k + 1] = poses[k] + [c * x - s * y, s * x + c * y, theta]
        poses[k + 1, 2] = wrapped(poses[k + 1, 2])
    return poses


def pose_graph(false_closures=0):
    """Two rounds on a circle, with loop closures: i, j and the pose j as seen from i. The odometry comes first."""
    random = np.random.default_rng(1)
    t = np.linspace(0, 4 * np.pi, 100, endpoint=False)
    truth = np.c_[5 * np.sin(t), 5 - 5 * np.cos(t), wrapped(t)]
    early = np.arange(0, 50, 4)
    i, j = np.r_[np.arange(99), early], np.r_[np.arange(1, 100), early + 50]
    z = relative(truth[i], truth[j]) + SIGMAS * random.normal(size=(len(i), 3))
    z[99:99 + false_closures] += [2, -1, 1]
    return SimpleNamespace(i=i, j=j, z=z, guess=chained(z[:99]), omega=np.diag(1 / SIGMAS**2), truth=truth, odometry=99)


def landmarks():
    """A robot on a circle measures the angles and distances to landmarks."""
    random = np.random.default_rng(2)
    t = np.linspace(0, 2 * np.pi, 60)
    truth, points = np.c_[5 * np.sin(t), 5 - 5 * np.cos(t), wrapped(t)], random.uniform([-7, -3], [7, 13], (15, 2))
    odometry = relative(truth[:-1], truth[1:]) + SIGMAS * random.normal(size=(59, 3))
    pose, point = np.nonzero(np.linalg.norm(truth[:, None, :2] - points, axis=2) < 5)
    seen = relative(truth[pose], points[point])
    angles = np.arctan2(seen[:, 1], seen[:, 0]) + 0.02 * random.normal(size=len(seen))
    ranges = np.linalg.norm(seen, axis=1) + 0.1 * random.normal(size=len(seen))
    return SimpleNamespace(odometry=odometry, guess=chained(odometry), points_guess=points + random.normal(size=points.shape),
                           pose=pose, point=point, angles=angles, ranges=ranges, omega=np.diag(1 / SIGMAS**2), truth=truth,
                           points=points)


def poses_in_space(random, count, angle, distance):
    """x y z qx qy qz qw"""
    axes = random.normal(size=(count, 3))
    axes *= np.sin(angle / 2) / np.linalg.norm(axes, axis=1, keepdims=True)
    return np.c_[distance * random.normal(size=(count, 3)), axes, np.full(count, np.cos(angle / 2))]


def hand_eye():
    """Motions of a robot's hand and of the camera on it, in their own frames: robot X = X camera."""
    from boxplus import SE3, rows

    random = np.random.default_rng(3)
    truth = np.array([[0.1, -0.05, 0.2, 0.5, -0.5, 0.5, 0.5]])
    robot = poses_in_space(random, 30, 0.8, 0.5)
    x = np.repeat(truth, 30, axis=0)
    camera = rows.times(rows.inverse_times(x, rows.times(robot, x)), poses_in_space(random, 30, 0.002, 0.002))
    return SimpleNamespace(robot=robot, camera=camera, truth=SE3.from_vector(truth[0]))


def bundle():
    """12 cameras around 150 points. The poses of the cameras are in the world; the first two are known."""
    random = np.random.default_rng(4)
    points = random.uniform(-1, 1, (150, 3))
    angle = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    cameras = np.c_[-6 * np.sin(angle), 0 * angle, -6 * np.cos(angle), 0 * angle, np.sin(angle / 2), 0 * angle, np.cos(angle / 2)]
    camera, point = (index.ravel() for index in np.meshgrid(np.arange(12), np.arange(150), indexing="ij"))
    x, z = (points[point] - cameras[camera, :3])[:, ::2].T
    c, s = np.cos(angle[camera]), np.sin(angle[camera])
    focal, center = 500.0, np.array([320.0, 240.0])
    image = np.c_[c * x - s * z, points[point, 1]] / (s * x + c * z)[:, None]
    pixels = focal * image + center + 0.5 * random.normal(size=image.shape)
    guess = cameras.copy()
    guess[2:] += 0.02 * random.normal(size=(10, 7))
    guess[:, 3:] /= np.linalg.norm(guess[:, 3:], axis=1, keepdims=True)
    return SimpleNamespace(cameras_guess=guess, points_guess=points + 0.05 * random.normal(size=points.shape), camera=camera,
                           point=point, pixels=pixels, focal=focal, center=center, points=points)


def curve():
    """A damped oscillation: amplitude, decay, frequency."""
    random = np.random.default_rng(5)
    t = np.linspace(0, 10, 200)
    return SimpleNamespace(t=t, y=2 * np.exp(-0.2 * t) * np.cos(3 * t) + 0.05 * random.normal(size=200), truth=[2, 0.2, 3])


def beacons():
    """A chain of poses that measure their distances from beacons: pose, beacon and distance."""
    random = np.random.default_rng(6)
    t = np.linspace(0, 2, 20)
    truth = np.c_[5 * np.sin(t), 5 - 5 * np.cos(t), t]
    places = np.array([[0.0, 5], [6, -1], [8, 8]])
    odometry = relative(truth[:-1], truth[1:]) + 3 * SIGMAS * random.normal(size=(19, 3))
    pose, beacon = (index.ravel() for index in np.meshgrid(np.arange(20), np.arange(3), indexing="ij"))
    distances = np.linalg.norm(truth[pose, :2] - places[beacon], axis=1) + 0.05 * random.normal(size=60)
    return SimpleNamespace(odometry=odometry, guess=chained(odometry), omega=np.diag(1 / (3 * SIGMAS)**2), pose=pose,
                           places=places[beacon], distances=distances, truth=truth)


def plan():
    """A straight path through round obstacles: x, y, radius."""
    return SimpleNamespace(path=np.linspace([0, 0], [10, 0.1], 50), obstacles=np.array([[3, 0.3, 1], [6.5, -0.4, 1.2]]), margin=0.3)


def sensor():
    """A robot with known poses sees landmarks with a sensor whose pose on the robot is not known."""
    random = np.random.default_rng(7)
    poses, points = np.c_[random.uniform(-5, 5, (20, 2)), random.uniform(-3, 3, 20)], random.uniform(-8, 8, (10, 2))
    offset = np.array([0.4, -0.1, 0.3])
    c, s = np.cos(poses[:, 2]), np.sin(poses[:, 2])
    sensors = np.c_[poses[:, 0] + c * 0.4 + s * 0.1, poses[:, 1] + s * 0.4 - c * 0.1, poses[:, 2] + 0.3]
    pose, point = (index.ravel() for index in np.meshgrid(np.arange(20), np.arange(10), indexing="ij"))
    seen = relative(sensors[pose], points[point]) + 0.02 * random.normal(size=(200, 2))
    return SimpleNamespace(poses=poses, points_guess=points + 0.3 * random.normal(size=points.shape), pose=pose, point=point,
                           seen=seen, truth=offset)


def online():
    """The pose graph, one motion after the other: closures[k] has the earlier poses that pose k recognizes."""
    world = pose_graph()
    closures = {}
    for i, j, z in list(zip(world.i, world.j, world.z))[world.odometry:]:
        closures.setdefault(int(j), []).append((int(i), z))
    return SimpleNamespace(odometry=world.z[:world.odometry], closures=closures, omega=world.omega, truth=world.truth)
