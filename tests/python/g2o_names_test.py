# SPDX-License-Identifier: BSD-3-Clause
"""The names that programs for g2o's Python bindings use."""

import inspect
import unittest

import g2o

CLASSES = """
    SparseOptimizer OptimizableGraph HyperGraph SparseOptimizerTerminateAction Flag SparseBlockMatrix SparseBlockMatrixX
    OptimizationAlgorithm OptimizationAlgorithmGaussNewton OptimizationAlgorithmLevenberg OptimizationAlgorithmDogleg
    RobustKernel RobustKernelHuber RobustKernelPseudoHuber RobustKernelCauchy RobustKernelGemanMcClure RobustKernelWelsch
    RobustKernelFair RobustKernelTukey RobustKernelSaturated RobustKernelDCS RobustKernelScaleDelta
    Quaternion Quaterniond AngleAxis Rotation2d Isometry2d Isometry3d Isometry3 SE2 SE3Quat Sim3 SBACam
    VertexSE2 VertexPointXY EdgeSE2 EdgeSE2Prior EdgeSE2XYPrior EdgeXYPrior EdgePointXY EdgeSE2PointXY EdgeSE2PointXYBearing
    EdgeSE2PointXYOffset EdgeSE2PointXYCalib EdgeSE2Offset EdgeSE2TwoPointsXY EdgeSE2LotsOfXY EdgeSE3LotsOfXYZ ParameterSE2Offset
    VertexSE3 VertexPointXYZ EdgeSE3 EdgeSE3Prior EdgeSE3XYZPrior EdgeSE3Offset EdgePointXYZ EdgeXYZPrior EdgeSE3PointXYZ
    EdgeSE3PointXYZDepth EdgeSE3PointXYZDisparity ParameterSE3Offset ParameterCamera
    VertexSBAPointXYZ VertexSE3Expmap VertexCam CameraParameters EdgeProjectXYZ2UV EdgeProjectXYZ2UVU EdgeProjectPSI2UV
    EdgeSE3ProjectXYZ EdgeStereoSE3ProjectXYZ EdgeSE3ProjectXYZOnlyPose EdgeStereoSE3ProjectXYZOnlyPose EdgeSE3Expmap
    EdgeProjectP2MC EdgeProjectP2SC EdgeSBACam EdgeSBAScale
    VertexSim3Expmap EdgeSim3 EdgeSim3ProjectXYZ EdgeInverseSim3ProjectXYZ
    EdgeGICP EdgeVVGicp Edge_V_V_GICP VertexSCam EdgeXYZVsc Edge_XYZ_VSC
    VectorXVertex VariableVectorXEdge BaseVertex BaseEdge BaseUnaryEdge BaseBinaryEdge
""".split() + [f"{solver}{size}" for solver in ("BlockSolver", "LinearSolverDense", "LinearSolverEigen", "LinearSolverCholmod",
                                                "LinearSolverCSparse", "LinearSolverPCG")
               for size in ("X", "SE2", "SE3", "Sim3", "SBA")]

METHODS = {
    "SparseOptimizer": """
        algorithm set_algorithm add_vertex add_edge add_parameter vertex vertices edges parameter remove_vertex remove_edge
        detach_vertex set_edge_vertex change_id clear initialize_optimization update_initialization optimize
        compute_initial_guess compute_active_errors compute_marginals chi2 active_chi2 active_robust_chi2 active_vertices
        active_edges index_mapping find_active_vertex find_active_edge find_gauge gauge_freedom set_verbose verbose
        set_force_stop_flag force_stop_flag terminate add_pre_iteration_action add_post_iteration_action
        remove_pre_iteration_action remove_post_iteration_action push pop discard_top load save""",
    "VertexSE3": """
        id set_id estimate set_estimate fixed set_fixed marginalized set_marginalized dimension edges graph hessian_index
        set_to_origin oplus push pop discard_top stack_size get_estimate_data set_estimate_data estimate_dimension user_data
        set_user_data""",
    "EdgeSE3": """
        id set_id vertices vertex set_vertex resize measurement set_measurement set_measurement_from_state measurement_dimension
        information set_information error chi2 compute_error dimension level set_level robust_kernel set_robust_kernel
        parameter_ids set_parameter_id parameter graph all_vertices_fixed""",
    "SE3Quat": """
        translation set_translation rotation set_rotation inverse log exp map adj to_vector from_vector to_minimal_vector
        from_minimal_vector to_homogeneous_matrix normalize_rotation matrix orientation position R t __mul__""",
    "Isometry3d": "translation rotation matrix inverse orientation position set_rotation set_translation R t __mul__ identity",
    "Quaternion": """
        x y z w vec coeffs norm normalize normalized conjugate inverse rotation_matrix to_rotation_matrix matrix dot slerp
        angular_distance identity set_identity from_two_vectors R __mul__""",
    "SE2": "translation rotation to_vector from_vector inverse to_isometry __mul__ __getitem__",
    "CameraParameters": "set_id id cam_map stereocam_uvu_map focal_length principal_point baseline",
    "EdgeGICP": "make_rot0 make_rot1 prec0 prec1 cov0 cov1",
    "RobustKernelHuber": "delta set_delta robustify",
    "VectorXVertex": "set_dimension oplus_impl set_to_origin_impl estimate set_estimate",
    "VariableVectorXEdge": "set_dimension resize compute_error set_measurement set_information",
}


class Names(unittest.TestCase):
    def test_the_classes_are_there(self):
        for name in CLASSES:
            self.assertTrue(inspect.isclass(getattr(g2o, name)), name)
            self.assertIn(name, g2o.__all__)

    def test_the_methods_are_there(self):
        for name, methods in METHODS.items():
            self.assertEqual([method for method in methods.split() if not hasattr(getattr(g2o, name), method)], [], name)

    def test_every_solver_can_be_made_from_every_linear_solver(self):
        for size in ("X", "SE2", "SE3", "Sim3", "SBA"):
            for name in ("Dense", "Eigen", "Cholmod", "CSparse", "PCG"):
                solver = getattr(g2o, f"BlockSolver{size}")(getattr(g2o, f"LinearSolver{name}{size}")())
                for algorithm in (g2o.OptimizationAlgorithmGaussNewton, g2o.OptimizationAlgorithmLevenberg,
                                  g2o.OptimizationAlgorithmDogleg):
                    self.assertIs(algorithm(solver).solver(), solver)

    def test_no_name_of_the_implementation_is_exported(self):
        self.assertEqual([name for name in g2o.__all__ if name.startswith("_") or not inspect.isclass(getattr(g2o, name))], [])


if __name__ == "__main__":
    unittest.main()
