// SPDX-License-Identifier: MIT
#include "limitcurve/pair.hpp"

namespace limitcurve {

const Paired paired{Pair{0.5, 0.5}, Pair{1.0, 1.0}, Pair{3.0, 3.0}, Pair{0x1.8p52, 0x1.8p52}, Pair{-0.0, -0.0}};

}  // namespace limitcurve
