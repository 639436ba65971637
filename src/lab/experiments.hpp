// The experiments, each in a file of its own.
#pragma once

#include "delone/lab/experiment.hpp"

namespace delone::lab {

Experiment triangles_experiment();
Experiment scope_experiment();
Experiment location_experiment();
Experiment batch_experiment();
Experiment spheres_experiment();
Experiment dimensions_experiment();
Experiment flips_experiment();
Experiment optimal_experiment();
Experiment arithmetic_experiment();
Experiment order_k_experiment();

}  // namespace delone::lab
