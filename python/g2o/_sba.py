# SPDX-License-Identifier: BSD-3-Clause
"""Bundle adjustment. Images are in pixels. A VertexSE3Expmap is the motion from the world frame to the frame of a camera; its
step is (omega, upsilon), with T ⊞ step = exp(step) T."""

import numpy as np

from . import _kinds, _rows
from ._codecs import NUMBER, POINT2, POINT3, QUAT
from ._elements import Edge, Parameter, Vertex
from ._geometry import vector
from ._poses import SE3Quat
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

    def _intrinsics(self):
        focal, cx, cy, baseline = self._values
        return np.array([focal, focal, cx, cy, focal * baseline])

    def cam_map(self, point):
        """(u, v) of a point in the frame of the camera."""
        return pinhole(vector(point, 3, "point")[None], self._intrinsics()[None, :4])[0]

    def stereocam_uvu_map(self, point):
        """(u, v, u_right)."""
        return pinhole(vector(point, 3, "point")[None], self._intrinsics()[None])[0]


def pinhole(p, intrinsics):
    """(u, v) with fx, fy, cx, cy; (u, v, u - bf / depth) with fx, fy, cx, cy, bf."""
    image = intrinsics[:, :2] * p[:, :2] / p[:, 2:] + intrinsics[:, 2:4]
    if intrinsics.shape[1] == 4:
        return image
    return np.concatenate([image, image[:, :1] - intrinsics[:, 4:] / p[:, 2:]], axis=1)


class ImageOfPoint(Edge):
    """An edge with the error z − (u, v), or z − (u, v, u_right): vertices point, camera. Its data are z, the intrinsics for
    pinhole(), and the point Xw if it is no vertex. _intrinsics() may return bf even if the edge does not need it."""

    def _data(self):
        return np.concatenate([self._z, self._intrinsics()[:self._DIM + 2], getattr(self, "Xw", ())])

    @classmethod
    def _parts(cls, data, rows):
        """z, the intrinsics, the point and the camera."""
        first, end = cls._DIM, 2 * cls._DIM + 2
        return data[:, :first], data[:, first:end], *((data[:, end:],) if len(rows) == 1 else ()), *rows

    @classmethod
    def _residuals(cls, data, *rows):
        z, intrinsics, p, x = cls._parts(data, rows)
        return z - pinhole(_rows.out_of(x, p), intrinsics)

    @classmethod
    def _jacobians(cls, data, *rows):
        z, intrinsics, p, x = cls._parts(data, rows)
        seen = _rows.out_of(x, p)
        J = np.zeros((*z.shape, 3))  # by points in the frame of the camera
        J[:, [0, 1], [0, 1]] = -intrinsics[:, :2] / seen[:, 2:]
        J[:, :2, 2] = intrinsics[:, :2] * seen[:, :2] / seen[:, 2:]**2
        if cls._DIM == 3:
            J[:, 2] = J[:, 0]
            J[:, 2, 2] -= intrinsics[:, 4] / seen[:, 2]**2
        by_point = J @ _rows.matrix_of(x[:, 3:])
        # T ⊞ (v, w) moves T p by R (v + 2 w × p).
        by_pose = np.concatenate([by_point, 2 * np.cross(p[:, None], by_point)], axis=2)
        return (by_point, by_pose)[-len(rows):]


class VertexSBAPointXYZ(VertexPointXYZ):
    _TAG = "VERTEX_XYZ"


class VertexSE3Expmap(Vertex):
    _TAG, _KIND, _CODEC = "VERTEX_SE3:EXPMAP", _kinds.SE3, QUAT

    def _oplus(self, step):
        self._row = (SE3Quat.exp(step) * self.estimate())._row

    def _tangent(self):
        """boxplus steps by (translation, half the rotation) in the frame of the pose."""
        step = self.estimate().inverse().adj()
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


class _WithParameter(ImageOfPoint):
    """Edges whose parameter is a CameraParameters."""

    _VERTICES, _PARAMETERS = (VertexPointXYZ, VertexSE3Expmap), (CameraParameters,)

    def _intrinsics(self):
        return self._parameter(0)._intrinsics()


class EdgeProjectXYZ2UV(_WithParameter):
    """The image of a point: vertices point, camera; the parameter is a CameraParameters."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_XYZ2UV:EXPMAP", POINT2, 2


class EdgeProjectXYZ2UVU(_WithParameter):
    """(u, v, u_right) of a point in a stereo camera."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_XYZ2UVU:EXPMAP", POINT3, 3


class EdgeProjectPSI2UV(_WithParameter):
    """The image of a point (x / z, y / z, 1 / z) in the frame of an anchor: vertices point, camera, anchor."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_PSI2UV:EXPMAP", POINT2, 2
    _VERTICES, _jacobians = (VertexPointXYZ, VertexSE3Expmap, VertexSE3Expmap), None

    @staticmethod
    def _residuals(data, psi, x, anchor):
        p = np.concatenate([psi[:, :2], 1 + 0 * psi[:, :1]], axis=1) / psi[:, 2:]
        return data[:, :2] - pinhole(_rows.out_of(x, _rows.into(anchor, p)), data[:, 2:])


class _WithIntrinsics(ImageOfPoint):
    """Edges with intrinsics of their own, which are attributes."""

    _VERTICES = (VertexPointXYZ, VertexSE3Expmap)
    _FIELDS = {"fx": 1.0, "fy": 1.0, "cx": 0.0, "cy": 0.0}

    def __init__(self):
        super().__init__()
        self.__dict__.update(self._FIELDS)

    def __setattr__(self, name, value):
        super().__setattr__(name, value)
        if name in self._FIELDS or name == "Xw":
            self._changed()

    def _intrinsics(self):
        return np.array([getattr(self, name) for name in self._FIELDS], dtype=float)

    def is_depth_positive(self):
        """True if the point is in front of the camera."""
        x = self._vertices[-1]._row[None]
        p = self._vertices[0]._row if len(self._vertices) == 2 else vector(self.Xw, 3, "Xw")
        return bool(_rows.out_of(x, p[None])[0, 2] > 0)

    def cam_project(self, point):
        """The image of a point in the frame of the camera."""
        return pinhole(vector(point, 3, "point")[None], self._intrinsics()[None])[0]


_STEREO = {**_WithIntrinsics._FIELDS, "bf": 1.0}


class EdgeSE3ProjectXYZ(_WithIntrinsics):
    """The image of a point in a camera with fx, fy, cx, cy: vertices point, camera."""

    _TAG, _CODEC, _DIM = "EDGE_SE3_PROJECT_XYZ:EXPMAP", POINT2, 2


class EdgeStereoSE3ProjectXYZ(_WithIntrinsics):
    """(u, v, u_right) of a point in a stereo camera with fx, fy, cx, cy and bf (baseline times fx)."""

    _TAG, _CODEC, _DIM, _FIELDS = "EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP", POINT3, 3, _STEREO


class EdgeSE3ProjectXYZOnlyPose(_WithIntrinsics):
    """The image of the known point Xw."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP", (VertexSE3Expmap,), POINT2, 2
    Xw = (0.0, 0.0, 1.0)


class EdgeStereoSE3ProjectXYZOnlyPose(_WithIntrinsics):
    """(u, v, u_right) of the known point Xw."""

    _TAG, _VERTICES, _CODEC, _DIM = "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP", (VertexSE3Expmap,), POINT3, 3
    _FIELDS = _STEREO
    Xw = (0.0, 0.0, 1.0)


class ImageInPose(ImageOfPoint):
    """An edge with the error (u, v) − z, or (u, v, u_right) − z, whose vertex is the pose of the camera in the world."""

    _VERTICES, _jacobians = (VertexPointXYZ, VertexCam), None

    def _intrinsics(self):
        fx, fy, cx, cy, baseline = self._vertices[1]._intrinsics
        return np.array([fx, fy, cx, cy, fx * baseline])

    @classmethod
    def _residuals(cls, data, p, x):
        return pinhole(_rows.into(x, p), data[:, cls._DIM:]) - data[:, :cls._DIM]


class EdgeProjectP2MC(ImageInPose):
    """The image of a point in a VertexCam: vertices point, camera."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_P2MC", POINT2, 2


class EdgeProjectP2SC(ImageInPose):
    """(u, v, u_right) of a point in a VertexCam."""

    _TAG, _CODEC, _DIM = "EDGE_PROJECT_P2SC", POINT3, 3


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
