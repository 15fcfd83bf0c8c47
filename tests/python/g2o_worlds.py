# SPDX-License-Identifier: BSD-3-Clause
"""Graphs for the tests of the package g2o, with every ready-made type of vertex and edge that has a tag."""

import g2o
import numpy as np


def pose2(random, size=1.0):
    return g2o.SE2(*(size * random.normal(size=2)), random.uniform(-3, 3))


def pose3(random, size=1.0):
    return g2o.Isometry3d(g2o.Quaternion(random.normal(size=4)).normalized(), size * random.normal(size=3))


def near(random, pose):
    """A pose close to another one."""
    turn = g2o.Quaternion(np.append(0.1 * random.normal(size=3), 1)).normalized()
    return pose * g2o.Isometry3d(turn, 0.1 * random.normal(size=3))


def omega(random, size):
    A = random.normal(size=(size, size))
    return A @ A.T + np.eye(size)


def add(optimizer, make, id, estimate, fixed=False):
    vertex = make()
    vertex.set_id(id)
    vertex.set_estimate(estimate)
    vertex.set_fixed(fixed)
    assert optimizer.add_vertex(vertex)
    return vertex


def join(optimizer, make, vertices, measurement, random, parameters=(), **attributes):
    edge = make()
    edge.resize(len(vertices))
    for i, vertex in enumerate(vertices):
        edge.set_vertex(i, vertex)
    for i, id in enumerate(parameters):
        edge.set_parameter_id(i, id)
    for name, value in attributes.items():
        setattr(edge, name, value)
    if measurement is not None:
        edge.set_measurement(measurement)
    if make is not g2o.EdgeVVGicp:
        edge.set_information(omega(random, edge.dimension()))
    assert optimizer.add_edge(edge), edge
    return edge


def parameter(optimizer, make, id, **setters):
    result = make()
    result.set_id(id)
    for name, arguments in setters.items():
        getattr(result, name)(*arguments)
    assert optimizer.add_parameter(result)


def plane(optimizer, random, first=0):
    poses = [add(optimizer, g2o.VertexSE2, first + i, pose2(random), i == 0) for i in range(3)]
    points = [add(optimizer, g2o.VertexPointXY, first + 10 + i, random.normal(size=2)) for i in range(3)]
    sensor = add(optimizer, g2o.VertexSE2, first + 20, pose2(random, 0.1), True)
    for id in (0, 1):
        parameter(optimizer, g2o.ParameterSE2Offset, id, set_offset=(pose2(random, 0.1),))
    for make, vertices, z, parameters in (
            (g2o.EdgeSE2, poses[:2], pose2(random), ()), (g2o.EdgeSE2, poses[1:], pose2(random), ()),
            (g2o.EdgeSE2Prior, poses[1:2], pose2(random), ()), (g2o.EdgeSE2XYPrior, poses[2:], random.normal(size=2), ()),
            (g2o.EdgeXYPrior, points[:1], random.normal(size=2), ()), (g2o.EdgePointXY, points[:2], random.normal(size=2), ()),
            (g2o.EdgeSE2PointXY, [poses[0], points[2]], random.normal(size=2), ()),
            (g2o.EdgeSE2PointXYBearing, [poses[1], points[0]], 0.7, ()),
            (g2o.EdgeSE2PointXYOffset, [poses[1], points[2]], random.normal(size=2), (1,)),
            (g2o.EdgeSE2PointXYCalib, [poses[2], points[1], sensor], random.normal(size=2), ()),
            (g2o.EdgeSE2Offset, [poses[2], poses[0]], pose2(random), (0, 1)),
            (g2o.EdgeSE2TwoPointsXY, [poses[1], points[0], points[1]], random.normal(size=4), ()),
            (g2o.EdgeSE2LotsOfXY, [poses[2], points[1], points[2], points[0]], random.normal(size=(3, 2)), ()),
            (g2o.EdgeSE2LotsOfXY, [poses[0], points[1]], random.normal(size=2), ())):
        join(optimizer, make, vertices, z, random, parameters)


def space(optimizer, random, first=100):
    center = pose3(random)
    poses = [add(optimizer, g2o.VertexSE3, first + i, near(random, center), i == 0) for i in range(3)]
    points = [add(optimizer, g2o.VertexPointXYZ, first + 10 + i, center * [0.3 * i, 0.2, 4.0 + i]) for i in range(3)]
    for id in (10, 11):
        parameter(optimizer, g2o.ParameterSE3Offset, id, set_offset=(near(random, g2o.Isometry3d()),))
    parameter(optimizer, g2o.ParameterCamera, 12, set_offset=(near(random, g2o.Isometry3d()),), set_kcam=(5, 6, 1, 2))
    small = [near(random, g2o.Isometry3d()) for _ in range(4)]
    for make, vertices, z, parameters in (
            (g2o.EdgeSE3, poses[:2], small[0], ()), (g2o.EdgeSE3, poses[1:], small[1], ()),
            (g2o.EdgeSE3Prior, poses[1:2], near(random, center), (10,)),
            (g2o.EdgeSE3XYZPrior, poses[2:], random.normal(size=3), (10,)),
            (g2o.EdgeSE3Offset, [poses[2], poses[0]], small[2], (10, 11)),
            (g2o.EdgePointXYZ, points[:2], random.normal(size=3), ()),
            (g2o.EdgeXYZPrior, points[:1], points[0].estimate() + 0.1, ()),
            (g2o.EdgeSE3PointXYZ, [poses[0], points[0]], [0, 0.1, 4], (11,)),
            (g2o.EdgeSE3PointXYZDepth, [poses[1], points[1]], [1, 2, 4.5], (12,)),
            (g2o.EdgeSE3PointXYZDisparity, [poses[2], points[2]], [1, 2, 0.2], (12,)),
            (g2o.EdgeSE3LotsOfXYZ, [poses[1], points[0], points[2]], [[0, 0, 4], [0.6, 0, 6]], ())):
        join(optimizer, make, vertices, z, random, parameters)
    pair = g2o.EdgeGICP()
    pair.pos0, pair.pos1, pair.normal0 = random.normal(size=3), random.normal(size=3), np.array([0.6, 0, 0.8])
    edge = join(optimizer, g2o.EdgeVVGicp, poses[1:], pair, random)
    edge.set_information(pair.prec0(0.01))


def cameras(optimizer, random, first=200):
    motion = g2o.SE3Quat(near(random, g2o.Isometry3d()))
    views = [add(optimizer, g2o.VertexSE3Expmap, first + i, g2o.SE3Quat(near(random, motion)), i == 0) for i in range(3)]
    points = [add(optimizer, g2o.VertexSBAPointXYZ, first + 10 + i, [0.3 * i, 0.2, 4.0 + i]) for i in range(2)]
    psi = add(optimizer, g2o.VertexPointXYZ, first + 20, [0.1, -0.2, 0.25])
    camera = g2o.CameraParameters(5.0, [1.0, 2.0], 0.3)
    camera.set_id(20)
    optimizer.add_parameter(camera)
    intrinsics = {"fx": 5.0, "fy": 6.0, "cx": 1.0, "cy": 2.0}
    join(optimizer, g2o.EdgeSE3Expmap, views[:2], g2o.SE3Quat(near(random, g2o.Isometry3d())), random)
    join(optimizer, g2o.EdgeProjectXYZ2UV, [points[0], views[0]], [1, 2], random, (20,))
    join(optimizer, g2o.EdgeProjectXYZ2UVU, [points[1], views[1]], [1, 2, 0.5], random, (20,))
    join(optimizer, g2o.EdgeProjectPSI2UV, [psi, views[1], views[2]], [1, 2], random, (20,))
    join(optimizer, g2o.EdgeSE3ProjectXYZ, [points[0], views[2]], [1, 2], random, **intrinsics)
    join(optimizer, g2o.EdgeStereoSE3ProjectXYZ, [points[1], views[0]], [1, 2, 0.5], random, **intrinsics, bf=1.5)
    join(optimizer, g2o.EdgeSE3ProjectXYZOnlyPose, views[1:2], [1, 2], random, **intrinsics, Xw=[0.1, 0.2, 4])
    join(optimizer, g2o.EdgeStereoSE3ProjectXYZOnlyPose, views[2:], [1, 2, 0.5], random, **intrinsics, bf=1.5, Xw=[0.1, 0.2, 4])
    cams = []
    for i in range(2):
        cam = g2o.SBACam(near(random, g2o.Isometry3d()))
        cam.set_kcam(5, 6, 1, 2, 0.3)
        cams.append(add(optimizer, g2o.VertexCam, first + 30 + i, cam, i == 0))
    join(optimizer, g2o.EdgeProjectP2MC, [points[0], cams[0]], [1, 2], random)
    join(optimizer, g2o.EdgeProjectP2SC, [points[1], cams[1]], [1, 2, 0.5], random)
    join(optimizer, g2o.EdgeSBACam, cams, g2o.SE3Quat(near(random, g2o.Isometry3d())), random)
    join(optimizer, g2o.EdgeSBAScale, cams, 0.4, random)


def similarities(optimizer, random, first=300):
    views = []
    for i in range(2):
        pose = near(random, g2o.Isometry3d())
        views.append(add(optimizer, g2o.VertexSim3Expmap, first + i, g2o.Sim3(pose.orientation(), pose.t, 1 + 0.1 * i), i == 0))
        views[i].focal_length1, views[i].principle_point2 = [5, 6], [1, 2]
    point = add(optimizer, g2o.VertexPointXYZ, first + 10, [0.3, 0.2, 4])
    join(optimizer, g2o.EdgeSim3, views, g2o.Sim3(g2o.Quaternion(), [0.1, 0.2, 0.3], 1.2), random)
    join(optimizer, g2o.EdgeSim3ProjectXYZ, [point, views[0]], [1, 2], random)
    join(optimizer, g2o.EdgeInverseSim3ProjectXYZ, [point, views[1]], [1, 2], random)


WORLDS = {"plane": plane, "space": space, "cameras": cameras, "similarities": similarities}


def optimizer_for(world, seed=1, algorithm=g2o.OptimizationAlgorithmLevenberg):
    optimizer = g2o.SparseOptimizer()
    optimizer.set_algorithm(algorithm(g2o.BlockSolverX(g2o.LinearSolverEigenX())))
    WORLDS[world](optimizer, np.random.default_rng(seed))
    return optimizer


def square():
    """Four poses with measurements that do not agree, and a fixed vertex."""
    random = np.random.default_rng(3)
    optimizer = g2o.SparseOptimizer()
    optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(g2o.BlockSolverSE2(g2o.LinearSolverCholmodSE2())))
    poses = [add(optimizer, g2o.VertexSE2, i, g2o.SE2(*estimate), i == 0)
             for i, estimate in enumerate([(0, 0, 0), (1.9, 0.2, 1.4), (2.1, 2.2, 3.0), (0.3, 1.8, -1.7)])]
    for i in range(4):
        edge = join(optimizer, g2o.EdgeSE2, [poses[i], poses[(i + 1) % 4]], g2o.SE2(2 + 0.1 * i, 0, np.pi / 2), random)
        edge.set_information(np.diag([100, 100, 400]))
    return optimizer
