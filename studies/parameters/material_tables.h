#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mpm/membranes/membrane.h"
#include "studies/input/table_keys.h"

namespace zona::studies {

/// Keys of material laws that the tables of several kinds have: [zona], [[body]], [material]. Each
/// call declares the keys of a struct in the section that is open; all of them apply only under
/// `conditions`.

/// Keys c0, c1 and elastic_limit of mpm::Elastodamage.
void declare_elastodamage(Schema& schema, const std::string& section,
                          const std::vector<Condition>& conditions = {});

/// Von Mises plasticity (5.12)-(5.15).
struct Plasticity {
  double yield_strength;                ///< sigma_y [Pa]
  std::optional<double> peak_strength;  ///< sigma_p [Pa]; empty: the yield strength
  double hardening_modulus;             ///< E_h [Pa]
  double softening_modulus;             ///< E_s [Pa]

  /// Defaults in the user's notation.
  struct Defaults {
    std::string yield_strength;  ///< empty: it must be given
    std::string peak_strength;   ///< or "auto": no hardening
    std::string hardening_modulus;
    std::string softening_modulus;
  };
  static Defaults zona();     ///< of the zona pellucida (5.4)
  static Defaults perfect();  ///< of a solid that flows at a constant strength of its own

  mpm::VonMises law() const;
};
/// Complains of incompatible strengths and moduli.
void declare_plasticity(Schema& schema, const std::string& section,
                        const Plasticity::Defaults& defaults,
                        const std::vector<Condition>& conditions = {});

/// Decohesion (5.32)-(5.42).
struct Separation {
  double reference_opening;                  ///< u_0 [m]
  double decohesion_exponent;                ///< q [-]
  double mode_ratio;                         ///< c_m [-]
  std::optional<double> reference_traction;  ///< tau_0 [Pa]; empty: where the surface appears

  /// `cell` are the edges of the grid's cells [m].
  mpm::Decohesion law(const Eigen::Vector3d& cell) const;
};
void declare_separation(Schema& schema, const std::string& section,
                        const std::vector<Condition>& conditions = {});

/// Von Mises plasticity from a table with the keys of Plasticity; with decohesion from those of
/// Separation, if wanted. `cell` are the edges of the grid's cells [m].
mpm::VonMises plastic_law(const Table& table, bool with_decohesion, const Eigen::Vector3d& cell);

/// Kinematics of a membrane's strain.
enum class MembraneKinematics { source, objective };

/// Stress update of an elastic membrane (5.42).
enum class StressUpdate { total, increments };

/// Choices of a membrane's kinematics and laws; each is declared by a call of its own.
struct MembraneOptions {
  mpm::Localization bifurcation = mpm::Localization::plane_stress;
  mpm::OneWay one_way = mpm::OneWay::stress;
  StressUpdate stress_update = StressUpdate::total;
  MembraneKinematics kinematics = MembraneKinematics::source;

  mpm::MembraneLaw elastic_law() const;
};
void declare_bifurcation(Schema& schema, const std::string& section,
                         const std::vector<Condition>& conditions = {});
void declare_one_way(Schema& schema, const std::string& section,
                     const std::vector<Condition>& conditions = {});
void declare_stress_update(Schema& schema, const std::string& section,
                           const std::vector<Condition>& conditions = {});
void declare_kinematics(Schema& schema, const std::string& section,
                        const std::vector<Condition>& conditions = {});

}  // namespace zona::studies
