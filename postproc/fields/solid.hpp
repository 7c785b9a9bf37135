// Parts of a mesh made for a picture: cut by a box, its outer faces, repeated across a plane of symmetry.
#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include "spec/spec.hpp"

namespace stiction::postproc {

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// What lies within the box, perhaps nothing; cells across its sides are cut, second-order ones into straight
/// pieces.
[[nodiscard]] Grid cropped(Grid const& grid, CropBox const& box);

/// What of the lines lies within the box, with its images across the planes of the axes in `mirror`.
[[nodiscard]] vtkSmartPointer<vtkPolyData> cropped_lines(vtkPolyData& lines, CropBox const& box,
                                                         std::vector<int> const& mirror);

/// The faces that belong to one cell only, of their own order, with the data of points and cells.
[[nodiscard]] Grid outer_faces(Grid const& grid);

/// Without the faces that lie in the plane of one of these axes.
[[nodiscard]] Grid off_planes(Grid const& faces, std::vector<int> const& axes);

/// The grid of plane cells with its image across the plane where coordinate `axis` is 0. Points in
/// the plane are shared, so no seam remains, and plane cells within it, being inside now, are left out. Only
/// the array "shown" is kept, times `sign` in the image. Throws core::RunError when the grid lies on both
/// sides.
[[nodiscard]] Grid mirrored(Grid const& grid, int axis, double sign);

/// -1 where the image of a component changes sign: of a vector (3 numbers) along the axis, of a tensor (6:
/// xx yy zz xy yz xz) with the axis once; else 1. No component is a magnitude.
[[nodiscard]] double mirror_sign(int axis, int numbers, std::optional<int> component);

} // namespace stiction::postproc
