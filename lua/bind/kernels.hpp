// Which kernels OpenBLAS computes with.
#pragma once

namespace stiction::bind {

/// OpenBLAS takes a processor younger than itself for one of 2004, whose kernels take twice as long
/// for dense matrices. Where it does, this starts the program again with OPENBLAS_CORETYPE, which it reads as
/// it is loaded, set to kernels that this processor has the instructions for. Nothing where the variable is
/// set already.
void take_kernels_of_processor(char** words);

} // namespace stiction::bind
