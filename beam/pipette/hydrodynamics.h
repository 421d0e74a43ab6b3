#pragma once

#include <complex>

/// The load of a viscous liquid on a long cylinder that vibrates, and on a tube that it fills.
namespace zona::beam {

/// A liquid that rubs on the pipette.
struct Liquid {
  double density = 1000;      ///< [kg/m^3]
  double viscosity = 8.9e-4;  ///< [Pa s]; water at 25 degrees Celsius
};

/// Where a liquid moves past a wall.
enum class Flow {
  across,  ///< around a cylinder that moves across itself
  along,   ///< around a cylinder that moves along itself
  within,  ///< in the bore of a tube that moves along itself, driven by the wall alone
};

/// lambda K1(lambda) / K0(lambda) of the modified Bessel functions, for |arg lambda| <= pi/4: what
/// Stokes' layer around a cylinder of radius a takes, with lambda = a sqrt(s rho / eta) in the
/// Laplace variable s. By the trapezoidal rule in K_n(z) = int_0^inf exp(-z cosh t) cosh(n t) dt,
/// whose error falls exponentially: 1e-13.
std::complex<double> outer_ratio(std::complex<double> lambda);

/// lambda I1(lambda) / I0(lambda), for |arg lambda| <= pi/4: what the layer within a bore takes.
/// By its continued fraction, for large |lambda| by its asymptotic series: 1e-11.
std::complex<double> bore_ratio(std::complex<double> lambda);

/// Gamma of a circular cylinder at the Reynolds number Re = rho omega a^2 / eta, for motion as
/// exp(-i omega t) (Sader, J. Appl. Phys. 84, 64, 1998, eq. 20): the force per length on the
/// displacement amplitude W is rho pi a^2 omega^2 Gamma W. Its real part is added mass, in units of
/// the mass of displaced liquid, its imaginary part drag.
std::complex<double> hydrodynamic_function(double reynolds_number);

/// What the liquid adds to a cylinder that vibrates with one frequency.
struct CylinderLoad {
  double mass = 0;  ///< added mass per length [kg/m]
  double drag = 0;  ///< force per length and velocity [Pa s]
};

/// At the radius [m] and the angular frequency [rad/s], both above 0.
CylinderLoad cylinder_load(const Liquid& liquid, double radius, double angular_frequency);

/// Viscous force per length and velocity [Pa s] in the Laplace domain, with lambda as above:
/// 4 pi eta `outer_ratio` across, without the force rho pi a^2 s that an inviscid liquid has, too;
/// 2 pi eta `outer_ratio` along; 2 pi eta `bore_ratio` within, which is s times the share
/// 2 I1/(lambda I0) of the liquid's mass that follows the wall.
std::complex<double> viscous_load(Flow flow, const Liquid& liquid, double radius,
                                  std::complex<double> s);

}  // namespace zona::beam
