#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "studies/parameters/box.h"

namespace zona::studies {

enum class ShapeName { box, sphere, cylinder, tube, grid, sheet, disc, icosphere };

const Words<ShapeName>& shape_names();

/// Whether a shape is a surface, as membranes have.
bool is_surface(ShapeName shape);

/// Initial shape of a [[body]]. Members that the shape does not have are zero or empty.
struct BodyShape : BoxKeys {
  ShapeName shape;
  Eigen::Vector3d center{0, 0, 0};                 ///< of a sphere, disc or icosphere [m]
  double radius;                                   ///< of those and of a cylinder [m]
  Eigen::Vector3d from{0, 0, 0};                   ///< centre of an end of a cylinder or tube [m]
  Eigen::Vector3d to{0, 0, 0};                     ///< centre of the other end [m]
  double inner_radius;                             ///< of a tube [m]
  double outer_radius;                             ///< of a tube [m]
  std::vector<std::string> outside;                ///< bodies whose shapes are cut out of a volume
  Eigen::Vector3d corner{0, 0, 0};                 ///< of a sheet [m]
  Eigen::Vector3d edge_u{0, 0, 0};                 ///< of a sheet, from its corner [m]
  Eigen::Vector3d edge_v{0, 0, 0};                 ///< the other one [m]
  int normal;                                      ///< axis along the normal of a disc
  std::optional<int> level;                        ///< of an icosphere; empty: by the cells
  std::optional<int> rings;                        ///< of a disc; empty: by the cells
  std::optional<std::array<int, 2>> sheet_points;  ///< along the edges; empty: by the cells
  std::array<int, 3> points_per_cell;              ///< of a volume
  std::optional<std::array<int, 3>> points;        ///< of a whole volume; empty: by the cells
};

/// Keys of the shape in the list of bodies, which is open. Complains of shapes without an extent
/// and of too many points.
void declare_shape(Schema& schema, const std::string& section);

}  // namespace zona::studies
