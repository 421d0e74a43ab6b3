#include "mpm/bodies/lattice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace zona::mpm {

double Lattice::volume() const {
  return std::accumulate(volumes.begin(), volumes.end(), 0.0);
}

Lattice fill_cells(const BackgroundGrid& grid, const std::array<int, 3>& per_cell,
                   const std::function<bool(const Eigen::Vector3d&)>& inside) {
  Lattice lattice;
  const auto& cells = grid.cells();
  const double volume = grid.cell_volume() / (per_cell[0] * per_cell[1] * per_cell[2]);
  const std::array<int, 3> count{cells[0] * per_cell[0], cells[1] * per_cell[1],
                                 cells[2] * per_cell[2]};
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        const Eigen::Vector3d natural((i + 0.5) / per_cell[0], (j + 0.5) / per_cell[1],
                                      (k + 0.5) / per_cell[2]);
        const Eigen::Vector3d place = grid.origin() + grid.cell_size().cwiseProduct(natural);
        if (inside(place)) lattice.add(place, volume);
      }
    }
  }
  return lattice;
}

Lattice box(const Eigen::Vector3d& low, const Eigen::Vector3d& high,
            const std::array<int, 3>& count) {
  const Eigen::Vector3d spacing =
      (high - low).cwiseQuotient(Eigen::Vector3d(count[0], count[1], count[2]));
  Lattice lattice;
  for (int k = 0; k < count[2]; ++k) {
    for (int j = 0; j < count[1]; ++j) {
      for (int i = 0; i < count[0]; ++i) {
        lattice.add(low + spacing.cwiseProduct(Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5)),
                    spacing.prod());
      }
    }
  }
  return lattice;
}

Lattice tube(const Tube& t, int radial, int circumferential, int axial) {
  const Eigen::Vector3d u = t.axis.unitOrthogonal();
  const Eigen::Vector3d v = t.axis.cross(u);
  const double dr = (t.outer_radius - t.inner_radius) / radial;
  const double dtheta = 2 * M_PI / circumferential;
  const double dl = t.length / axial;
  Lattice lattice;
  for (int a = 0; a < axial; ++a) {
    for (int r = 0; r < radial; ++r) {
      const double radius = t.inner_radius + (r + 0.5) * dr;
      for (int c = 0; c < circumferential; ++c) {
        const double theta = (c + 0.5) * dtheta;
        const Eigen::Vector3d place =
            t.end + (a + 0.5) * dl * t.axis + radius * (std::cos(theta) * u + std::sin(theta) * v);
        lattice.add(place, radius * dtheta * dr * dl);
      }
    }
  }
  return lattice;
}

namespace {

TriangulatedSurface icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  TriangulatedSurface s;
  for (int axis = 0; axis < 3; ++axis) {
    for (double one : {-1.0, 1.0}) {
      for (double phi : {-golden, golden}) {
        Eigen::Vector3d place = Eigen::Vector3d::Zero();
        place[(axis + 1) % 3] = one;
        place[(axis + 2) % 3] = phi;
        s.places.push_back(place.normalized());
      }
    }
  }
  // Faces: triples of vertices at the distance of an edge, oriented outward.
  const double edge = 2 / std::sqrt(1 + golden * golden);
  const auto near = [&](int a, int b) {
    return std::abs((s.places[a] - s.places[b]).norm() - edge) < 1e-9;
  };
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
        const bool outward = s.places[a].cross(s.places[b]).dot(s.places[c]) > 0;
        s.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
    }
  }
  return s;
}

void subdivide(TriangulatedSurface& s) {
  std::map<std::pair<int, int>, int> middle_of;
  const auto middle = [&](int a, int b) {
    const auto [entry, is_new] =
        middle_of.try_emplace(std::minmax(a, b), static_cast<int>(s.places.size()));
    if (is_new) s.places.push_back((s.places[a] + s.places[b]).normalized());
    return entry->second;
  };
  std::vector<Triangle> finer;
  for (const auto& [a, b, c] : s.triangles) {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  s.triangles = std::move(finer);
}

}  // namespace

TriangulatedSurface icosphere(const Eigen::Vector3d& center, double radius, int level) {
  TriangulatedSurface s = icosahedron();
  for (int l = 0; l < level; ++l) subdivide(s);
  for (auto& place : s.places) place = center + radius * place;
  return s;
}

TriangulatedSurface sheet(const Eigen::Vector3d& corner, const Eigen::Vector3d& edge_u,
                          const Eigen::Vector3d& edge_v, int count_u, int count_v) {
  TriangulatedSurface s;
  for (int v = 0; v < count_v; ++v) {
    for (int u = 0; u < count_u; ++u) {
      s.places.push_back(corner + edge_u * u / (count_u - 1) + edge_v * v / (count_v - 1));
    }
  }
  for (int v = 0; v + 1 < count_v; ++v) {
    for (int u = 0; u + 1 < count_u; ++u) {
      const int p = v * count_u + u;
      // Alternate the diagonals, so that the sheet has no preferred direction.
      if ((u + v) % 2 == 0) {
        s.triangles.insert(s.triangles.end(),
                           {{p, p + 1, p + count_u + 1}, {p, p + count_u + 1, p + count_u}});
      } else {
        s.triangles.insert(s.triangles.end(),
                           {{p, p + 1, p + count_u}, {p + 1, p + count_u + 1, p + count_u}});
      }
    }
  }
  return s;
}

TriangulatedSurface disc(const Eigen::Vector3d& center, int axis, double radius, int rings) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  TriangulatedSurface s;
  s.places.push_back(center);
  const auto point = [](int ring, int number) {
    return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + number % (6 * ring);
  };
  for (int ring = 1; ring <= rings; ++ring) {
    const double distance = radius * ring / rings;
    for (int i = 0; i < 6 * ring; ++i) {
      const double angle = M_PI * i / (3 * ring);
      Eigen::Vector3d place = center;
      place[u] += distance * std::cos(angle);
      place[v] += distance * std::sin(angle);
      s.places.push_back(place);
    }
    for (int sector = 0; sector < 6; ++sector) {
      for (int i = 0; i < ring; ++i) {
        const int outer = sector * ring + i;
        const int inner = sector * (ring - 1) + i;
        s.triangles.push_back({point(ring - 1, inner), point(ring, outer), point(ring, outer + 1)});
        if (i + 1 == ring) continue;
        s.triangles.push_back(
            {point(ring - 1, inner), point(ring, outer + 1), point(ring - 1, inner + 1)});
      }
    }
  }
  return s;
}

TriangulatedSurface in_traversal_order(const TriangulatedSurface& surface,
                                       const BackgroundGrid& grid) {
  const int count = static_cast<int>(surface.places.size());
  std::vector<std::array<int, 3>> key;  // brick, cell, point
  for (int p = 0; p < count; ++p) {
    const Eigen::Vector3d& x = surface.places[p];
    const auto cell = grid.cell_at(x.x(), x.y(), x.z());
    if (cell[0] < 0) return surface;  // the solver will refuse the point
    key.push_back({grid.brick_of(cell), BackgroundGrid::cell_in_brick(cell), p});
  }
  std::sort(key.begin(), key.end());
  TriangulatedSurface ordered;
  std::vector<int> number(count);
  for (int n = 0; n < count; ++n) {
    number[key[n][2]] = n;
    ordered.places.push_back(surface.places[key[n][2]]);
  }
  for (const auto& [a, b, c] : surface.triangles)
    ordered.triangles.push_back({number[a], number[b], number[c]});
  std::stable_sort(
      ordered.triangles.begin(), ordered.triangles.end(), [](const Triangle& s, const Triangle& t) {
        return *std::min_element(s.begin(), s.end()) < *std::min_element(t.begin(), t.end());
      });
  return ordered;
}

}  // namespace zona::mpm
