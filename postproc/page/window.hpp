// Rendering without a screen: a surfaceless EGL context and a VTK window that uses it.
#pragma once
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include "page/picture.hpp"

namespace stiction::postproc {

/// A window that exists in memory only, 8 samples per pixel.
/// Throws core::RunError when the machine offers no EGL.
[[nodiscard]] vtkSmartPointer<vtkRenderWindow> make_window(int width, int height);

/// Renders and reads the pixels back.
[[nodiscard]] Picture shoot(vtkRenderWindow& window);

} // namespace stiction::postproc
