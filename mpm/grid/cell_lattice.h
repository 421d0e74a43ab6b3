#pragma once

#include "mpm/grid/background_grid.h"

namespace zona::mpm {

/// Cells and nodes of a grid on one lattice with a margin of one place on each side. Place c holds
/// a cell and its lowest node, so that loops over cells and their neighbours run straight through
/// arrays, without a look at the edges of the grid.
struct CellLattice {
  /// Places for these cells along each axis, and for their nodes.
  explicit CellLattice(const std::array<int, 3>& along)
      : cells(along),
        row(cells[0] + 2),
        layer(static_cast<long>(row) * (cells[1] + 2)),
        first(layer + row + 1),
        last(layer * (cells[2] + 2)),
        size(last + layer + row + 1) {}

  std::array<int, 3> cells;  ///< along each axis
  long row;                  ///< distance of neighbours along y
  long layer;                ///< distance of neighbours along z
  long first;                ///< place of the first cell
  long last;                 ///< one after the place of the last node
  long size;                 ///< of arrays: neighbours above of all places exist

  /// Indices of the cell at a place.
  std::array<long, 3> indices(long at) const {
    const long from = at - first;
    return {from % layer % row, from % layer / row, from / layer};
  }
  /// Place of the cell, or of the node, with these indices.
  long place(int i, int j, int k) const { return first + k * layer + j * row + i; }
};

}  // namespace zona::mpm
