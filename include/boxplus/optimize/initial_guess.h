#pragma once
#include "boxplus/linearize/plan.h"
namespace boxplus {
struct GuessResult { bool made; std::string_view note; };
GuessResult guess_odometry(Graph&, const Plan&);
GuessResult guess_spanning_tree(Graph&, const Plan&);
GuessResult guess_chordal(Graph&, const Plan&);
}
