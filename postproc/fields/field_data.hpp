// What a field figure shows: one step of a run as a VTK grid, moved, cropped and in the unit wanted.
#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "fields/obstacles.hpp"

namespace stiction::postproc {

struct FieldData {
  vtkSmartPointer<vtkPolyData> surface; ///< carries the array "shown", in the unit of the figure
  vtkSmartPointer<vtkPolyData>
      edges; ///< cell edges of the mesh, on its surface when it is a solid; carry "shown" at their points
  bool on_cells = false;
  double low = 0, high = 0;   ///< of the values within the window
  std::optional<double> time; ///< s, where the files tell it
  Frame frame;
  Extent view;                  ///< the window, or everything
  std::optional<Vector> sphere; ///< its centre
  std::vector<Outline> obstacles;
};

/// The times of the frames that a .pvd lists, s. Throws core::RunError when it cannot be read.
[[nodiscard]] std::vector<double> times_of(std::filesystem::path const& index);

/// Throws core::RunError when file, step or array is missing, empty, or not finite;
/// core::InputError when the array has no such component or another dimension than the unit wanted.
[[nodiscard]] FieldData load_field(FieldSpec const& spec);

} // namespace stiction::postproc
