// Whether the bodies' matrix is factored or its loads are solved for by multigrid.
#pragma once
#include <string>

#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

/// Why multigrid cannot take this model, in words; "" if it can.
[[nodiscard]] std::string unfit_for_multigrid(Model const& model);
/// Why several ranks cannot share this model, in words; "" if they can.
[[nodiscard]] std::string unfit_for_ranks(Model const& model);
/// As the model asks for, or by the size of its matrix, the laws of its bodies and how compressible they are;
/// always where ranks share it.
[[nodiscard]] bool by_multigrid(Model const& model);
/// Why a model so large that multigrid would be quicker has a factor though it leaves the choice; "" where
/// that is not so.
[[nodiscard]] std::string kept_from_multigrid(Model const& model);

} // namespace stiction::dynamics
