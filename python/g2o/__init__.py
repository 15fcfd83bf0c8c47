# SPDX-License-Identifier: BSD-3-Clause
"""The names of g2o's Python bindings, on the engine of boxplus (docs/from_python.md).

Graphs for the class SparseOptimizer: poses and points of the plane and of space, cameras, similarities, pairs of points of
scans, and vertices and edges that are written in Python.
"""

from . import _solvers
from ._custom import BaseBinaryEdge, BaseEdge, BaseUnaryEdge, BaseVertex, VariableVectorXEdge, VectorXVertex
from ._elements import Edge, Parameter, Vertex
from ._geometry import AngleAxis, Isometry2d, Isometry3d, Quaternion, Rotation2d
from ._graph import HyperGraph
from ._icp import EdgeGICP, EdgeVVGicp, EdgeXYZVsc, VertexSCam
from ._kernels import (RobustKernel, RobustKernelCauchy, RobustKernelDCS, RobustKernelFair, RobustKernelGemanMcClure,
                       RobustKernelHuber, RobustKernelPseudoHuber, RobustKernelSaturated, RobustKernelScaleDelta,
                       RobustKernelTukey, RobustKernelWelsch)
from ._lots import EdgeSE2LotsOfXY, EdgeSE3LotsOfXYZ
from ._marginals import SparseBlockMatrix
from ._optimizer import SparseOptimizer, SparseOptimizerTerminateAction
from ._poses import SE2, SE3Quat, Sim3
from ._sba import (CameraParameters, EdgeProjectP2MC, EdgeProjectP2SC, EdgeProjectPSI2UV, EdgeProjectXYZ2UV,
                   EdgeProjectXYZ2UVU, EdgeSBACam, EdgeSBAScale, EdgeSE3Expmap, EdgeSE3ProjectXYZ,
                   EdgeSE3ProjectXYZOnlyPose, EdgeStereoSE3ProjectXYZ, EdgeStereoSE3ProjectXYZOnlyPose, SBACam, VertexCam,
                   VertexSBAPointXYZ, VertexSE3Expmap)
from ._sim3 import EdgeInverseSim3ProjectXYZ, EdgeSim3, EdgeSim3ProjectXYZ, VertexSim3Expmap
from ._slam2d import (EdgePointXY, EdgeSE2, EdgeSE2Offset, EdgeSE2PointXY, EdgeSE2PointXYBearing, EdgeSE2PointXYCalib,
                      EdgeSE2PointXYOffset, EdgeSE2Prior, EdgeSE2TwoPointsXY, EdgeSE2XYPrior, EdgeXYPrior,
                      ParameterSE2Offset, VertexPointXY, VertexSE2)
from ._slam3d import (EdgePointXYZ, EdgeSE3, EdgeSE3Offset, EdgeSE3PointXYZ, EdgeSE3PointXYZDepth,
                      EdgeSE3PointXYZDisparity, EdgeSE3Prior, EdgeSE3XYZPrior, EdgeXYZPrior, ParameterCamera,
                      ParameterSE3Offset, VertexPointXYZ, VertexSE3)
from ._solvers import (OptimizationAlgorithm, OptimizationAlgorithmDogleg, OptimizationAlgorithmGaussNewton,
                       OptimizationAlgorithmLevenberg)

globals().update(_solvers.ALL)
OptimizableGraph = HyperGraph
SparseBlockMatrixX = SparseBlockMatrix
# Other spellings of the bindings.
Isometry3, Isometry2, Rotation2D = Isometry3d, Isometry2d, Rotation2d
Quaterniond = Quaternion
Edge_V_V_GICP, Edge_XYZ_VSC = EdgeVVGicp, EdgeXYZVsc


class Flag:
    """A flag for SparseOptimizer.set_force_stop_flag()."""

    def __init__(self, value=False):
        self.value = bool(value)


__all__ = sorted(name for name in globals() if name[0].isupper())
