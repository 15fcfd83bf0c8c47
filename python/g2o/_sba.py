# SPDX-License-Identifier: BSD-3-Clause
"""Bundle adjustment. Images are in pixels. A VertexSE3Expmap is the motion from the world frame to the frame of a camera; its
step is (omega, upsilon), with T ⊞ step = exp(step) T."""

import numpy as np

from . import _kinds, _rows
from ._codecs import NUMBER, POINT2, POINT3, QUAT
from ._elements import Edge, Parameter, Vertex
from ._geometry import vector
from ._poses import SE3Quat, adjoint
from ._slam3d import VertexPointXYZ


class CameraParameters(Parameter):
    """A camera with one focal length, and the baseline (meters) to a second camera on its right."""

    _TAG = "PARAMS_CAMERAPARAMETERS"

    def __init__(self, focal_length=1.0, principal_point=(0, 0), baseline=0.5):
        super().__init__()
        self._values = np.array([focal_length, *vector(principal_point, 2, "principal point"), baseline], dtype=float)

    def _data(self):
        return self._values

    def _set(self, where, value):
        self._values = self._values.copy()
        self._values[where] = value
        self._changed()

    focal_length = property(lambda self: float(self._values[0]), lambda self, value: self._set(0, float(value)))
    baseline = property(lambda self: float(self._values[3]), lambda self, value: self._set(3, float(value)))
    principal_point = property(lambda self: self._values[1:3].copy(),
                               lambda self, value: self._set(slice(1, 3), vector(value, 2, "principal point")))
    principle_point = principal_point  # the spelling of C++

    def cam_map(self, point):
        """(u, v) of a point in the frame of the camera."""
        return _image(vector(point, 3, "point")[None], self._values[None])[0]

    def stereocam_uvu_map(self, point):
        """(u, v, u_right)."""
        return _stereo_image(vector(point, 3, "point")[None], self._values[None])[0]


def _image(p, camera):
    return camera[:, :1] * p[:, :2] / p[:, 2:] + camera[:, 1:3]


def _stereo_image(p, camera):
    image = _image(p, camera)
    return np.concatenate([image, image[:, :1] - camera[:, :1] * camera[:, 3:4] / p[:, 2:]], axis=1)


def pinhole(p, intrinsics):
    """(u, v) with fx, fy, cx, cy."""
    return intrinsics[:, :2] * p[:, :2] / p[:, 2:] + intrinsics[:, 2:4]


def pinhole_stereo(p, intrinsics):
    """(u, v, u - bf / depth) with fx, fy, cx, cy, bf."""
    image = pinhole(p, intrinsics)
    return np.concatenate([image, image[:, :1] - intrinsics[:, 4:5] / p[:, 2:]], axis=1)


def _minus_image_jacobians(seen, focal, bf=None):
    """The derivatives (n, 2 or 3, 3) of −(u, v), or of −(u, v, u_right), by points in the frame of the camera."""
    x, y, depth = seen.T
    J = np.zeros((len(seen), 2 if bf is None else 3, 3))
    J[:, 0, 0], J[:, 0, 2] = -focal[:, 0] / depth, focal[:, 0] * x / depth**2
    J[:, 1, 1], J[:, 1, 2] = -focal[:, 1] / depth, focal[:, 1] * y / depth**2
    if bf is not None:
        J[:, 2] = J[:, 0]
        J[:, 2, 2] -= bf / depth**2
    return J


def _by_point_and_pose(J, x, p):
    """The derivatives of errors of T p, whose derivatives by T p are J, by the point p and by the step of boxplus."""
    by_point = J @ _rows.matrix_of(x[:, 3:])
    # T ⊞ (v, w) moves T p by R (v + 2 w × p).
    by_turn = 2 * np.cross(p[:, None], by_point)
    return by_point, np.concatenate([by_point, by_turn], axis=2)


class _ImageOfPoint:
    """Edges with the error z − image(T p): vertices point, camera."""

    @classmethod
    def _jacobians(cls, data, p, x):
        focal, bf = cls._camera(data)
        return _by_point_and_pose(_minus_image_jacobians(_rows.out_of(x, p), focal, bf), x, p)


class _ImageOfKnownPoint:
    """Edges with the error z − image(T p): vertex camera. The known point comes last in the data."""

    @classmethod
    def _jacobians(cls, data, x):
        focal, bf = cls._camera(data)
        p = data[:, -3:]
        return _by_point_and_pose(_minus_image_jacobians(_rows.out_of(x, p), focal, bf), x, p)[1:]


class VertexSBAPointXYZ(VertexPointXYZ):
    _TAG = "VERTEX_XYZ"


class VertexSE3Expmap(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_SE3:EXPMAP", _kinds.SE3, QUAT

    def _oplus(self, step):
        self._row = _rows.compose(_rows.exponential(step[None]), self._row[None])[0]

    def _tangent(self):
        """boxplus steps by (translation, half the rotation) in the frame of the pose."""
        step = adjoint(_rows.inverse(self._row[None])[0])
        return np.vstack([step[3:], step[:3] / 2])


class SBACam(SE3Quat):
    """The pose of a camera in the world, its intrinsics, and the baseline to a second camera."""

    def __init__(self, *values):
        super().__init__(*values)
        self._intrinsics = values[0]._intrinsics.copy() if values and isinstance(values[0], SBACam) else np.array(
            [1.0, 1, 0, 0, 0.5])

    def set_kcam(self, fx, fy, cx, cy, tx):
        self._intrinsics = np.array([fx, fy, cx, cy, tx], dtype=float)

    set_cam = set_kcam

    def kcam(self):
        fx, fy, cx, cy, _ = self._intrinsics
        return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])

    baseline = property(lambda self: float(self._intrinsics[4]))


class VertexCam(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_CAM", _kinds.SE3, QUAT

    def __init__(self):
        super().__init__()
        self._intrinsics = SBACam()._intrinsics

    def estimate(self):
        camera = SBACam(self._CODEC.decode(self._row))
        camera._intrinsics = self._intrinsics.copy()
        return camera

    def set_estimate(self, estimate):
        if isinstance(estimate, SBACam):
            self._intrinsics = estimate._intrinsics.copy()
            for edge in self._edges:
                edge._changed()
        super().set_estimate(estimate)

    def _oplus(self, step):
        v = step[3:]
        squared = v @ v
        q = np.append(v, np.sqrt(1 - squared)) if squared < 1 else np.append(v / np.sqrt(squared), 0)
        self._row = np.append(self._row[:3] + step[:3], _rows.multiply(self._row[None, 3:], q[None])[0])

    def _tangent(self):
        """The translation of boxplus is in the frame of the camera."""
        D = np.eye(6)
        D[:3, :3] = _rows.matrix_of(self._row[None, 3:])[0].T
        return D


class EdgeSE3Expmap(Edge):
    """The motion from camera i to camera j: T_j = z T_i."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3:EXPMAP", (VertexSE3Expmap, VertexSE3Expmap), QUAT, 6

    @staticmethod
    def _residuals(z, a, b):
        return _rows.logarithm(_rows.compose(_rows.inverse(b), _rows.compose(z, a)))

    def set_measurement_from_state(self):
        self.set_measurement(self.vertex(1).estimate() * self.vertex(0).estimate().inverse())
        return True


class EdgeProjectXYZ2UV(_ImageOfPoint, Edge):
    """The image of a point: vertices point, camera; the parameter is a CameraParameters."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_XYZ2UV:EXPMAP", (VertexPointXYZ, VertexSE3Expmap), POINT2, 2
    _PARAMETERS = (CameraParameters,)

    @staticmethod
    def _camera(data):
        return data[:, [2, 2]], None

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :2] - _image(_rows.out_of(x, p), data[:, 2:])


class EdgeProjectXYZ2UVU(_ImageOfPoint, Edge):
    """(u, v, u_right) of a point in a stereo camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_XYZ2UVU:EXPMAP", (VertexPointXYZ, VertexSE3Expmap), POINT3, 3
    _PARAMETERS = (CameraParameters,)

    @staticmethod
    def _camera(data):
        return data[:, [3, 3]], data[:, 3] * data[:, 6]

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :3] - _stereo_image(_rows.out_of(x, p), data[:, 3:])


class EdgeProjectPSI2UV(Edge):
    """The image of a point (x / z, y / z, 1 / z) in the frame of an anchor: vertices point, camera, anchor."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_PSI2UV:EXPMAP", POINT2, 2
    _VERTICES = (VertexPointXYZ, VertexSE3Expmap, VertexSE3Expmap)
    _PARAMETERS = (CameraParameters,)

    @staticmethod
    def _residuals(data, psi, x, anchor):
        p = np.concatenate([psi[:, :2], 1 + 0 * psi[:, :1]], axis=1) / psi[:, 2:]
        return data[:, :2] - _image(_rows.out_of(x, _rows.into(anchor, p)), data[:, 2:])


class _WithIntrinsics(Edge):
    """Edges with intrinsics of their own, which are attributes."""

    _FIELDS = {"fx": 1.0, "fy": 1.0, "cx": 0.0, "cy": 0.0}

    def __init__(self):
        super().__init__()
        self.__dict__.update(self._FIELDS)

    def __setattr__(self, name, value):
        super().__setattr__(name, value)
        if name in self._FIELDS or name == "Xw":
            self._changed()

    def _data(self):
        return np.concatenate([self._z, [getattr(self, name) for name in self._FIELDS], getattr(self, "Xw", ())])

    def is_depth_positive(self):
        """True if the point is in front of the camera."""
        x = self._vertices[-1]._row[None]
        p = self._vertices[0]._row if len(self._vertices) == 2 else vector(self.Xw, 3, "Xw")
        return bool(_rows.out_of(x, p[None])[0, 2] > 0)

    def cam_project(self, point):
        """The image of a point in the frame of the camera."""
        project = pinhole_stereo if "bf" in self._FIELDS else pinhole
        intrinsics = np.array([[getattr(self, name) for name in self._FIELDS]])
        return project(vector(point, 3, "point")[None], intrinsics)[0]


_STEREO = {**_WithIntrinsics._FIELDS, "bf": 1.0}


class EdgeSE3ProjectXYZ(_ImageOfPoint, _WithIntrinsics):
    """The image of a point in a camera with fx, fy, cx, cy: vertices point, camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3_PROJECT_XYZ:EXPMAP", (VertexPointXYZ, VertexSE3Expmap), POINT2, 2

    @staticmethod
    def _camera(data):
        return data[:, 2:4], None

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :2] - pinhole(_rows.out_of(x, p), data[:, 2:])


class EdgeStereoSE3ProjectXYZ(_ImageOfPoint, _WithIntrinsics):
    """(u, v, u_right) of a point in a stereo camera with fx, fy, cx, cy and bf (baseline times fx)."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP", (VertexPointXYZ, VertexSE3Expmap), POINT3, 3
    _FIELDS = _STEREO

    @staticmethod
    def _camera(data):
        return data[:, 3:5], data[:, 7]

    @staticmethod
    def _residuals(data, p, x):
        return data[:, :3] - pinhole_stereo(_rows.out_of(x, p), data[:, 3:])


class EdgeSE3ProjectXYZOnlyPose(_ImageOfKnownPoint, _WithIntrinsics):
    """The image of the known point Xw."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP", (VertexSE3Expmap,), POINT2, 2
    Xw = (0.0, 0.0, 1.0)

    @staticmethod
    def _camera(data):
        return data[:, 2:4], None

    @staticmethod
    def _residuals(data, x):
        return data[:, :2] - pinhole(_rows.out_of(x, data[:, 6:9]), data[:, 2:])


class EdgeStereoSE3ProjectXYZOnlyPose(_ImageOfKnownPoint, _WithIntrinsics):
    """(u, v, u_right) of the known point Xw."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP", (VertexSE3Expmap,), POINT3, 3
    _FIELDS = _STEREO
    Xw = (0.0, 0.0, 1.0)

    @staticmethod
    def _camera(data):
        return data[:, 3:5], data[:, 7]

    @staticmethod
    def _residuals(data, x):
        return data[:, :3] - pinhole_stereo(_rows.out_of(x, data[:, 8:11]), data[:, 3:])


class EdgeProjectP2MC(Edge):
    """The image of a point in a VertexCam: vertices point, camera."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_P2MC", (VertexPointXYZ, VertexCam), POINT2, 2

    def _data(self):
        return np.concatenate([self._z, self._vertices[1]._intrinsics])

    @staticmethod
    def _residuals(data, p, x):
        return pinhole(_rows.into(x, p), data[:, 2:]) - data[:, :2]


class EdgeProjectP2SC(Edge):
    """(u, v, u_right) of a point in a VertexCam."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_PROJECT_P2SC", (VertexPointXYZ, VertexCam), POINT3, 3

    def _data(self):
        fx, *_, baseline = self._vertices[1]._intrinsics
        return np.concatenate([self._z, self._vertices[1]._intrinsics[:4], [fx * baseline]])

    @staticmethod
    def _residuals(data, p, x):
        return pinhole_stereo(_rows.into(x, p), data[:, 3:]) - data[:, :3]


class EdgeSBACam(Edge):
    """The pose of camera j as seen from camera i."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_CAM", (VertexCam, VertexCam), QUAT, 6

    @staticmethod
    def _residuals(z, a, b):
        return _rows.relative(z, a, b)


class EdgeSBAScale(Edge):
    """The distance of two cameras."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SCALE", (VertexCam, VertexCam), NUMBER, 1

    @staticmethod
    def _residuals(z, a, b):
        return z - np.linalg.norm(b[:, :3] - a[:, :3], axis=1, keepdims=True)
