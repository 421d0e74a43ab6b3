#pragma once

#include <complex>

/// The load of a viscous liquid on a long cylinder that vibrates across itself.
namespace zona::beam {

/// A liquid at rest around the pipette.
struct Liquid {
  double density = 1000;      ///< [kg/m^3]
  double viscosity = 8.9e-4;  ///< [Pa s]; water at 25 degrees Celsius
};

/// lambda K1(lambda) / K0(lambda) of the modified Bessel functions, for |arg lambda| <= pi/4: the
/// viscous force on a cylinder of radius a per length and velocity is 4 pi eta times it, with
/// lambda = a sqrt(s rho / eta) in the Laplace variable s. By the trapezoidal rule in
/// K_n(z) = int_0^inf exp(-z cosh t) cosh(n t) dt, whose error falls exponentially: 1e-13.
std::complex<double> viscous_ratio(std::complex<double> lambda);

/// Its derivative with respect to lambda, lambda (K1^2 / K0^2 - 1).
std::complex<double> viscous_ratio_slope(std::complex<double> lambda);

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

/// Viscous force per length and velocity [Pa s] in the Laplace domain, without the force that an
/// inviscid liquid has, rho pi a^2 s: 4 pi eta `viscous_ratio`(a sqrt(s rho/eta)).
std::complex<double> viscous_load(const Liquid& liquid, double radius, std::complex<double> s);

}  // namespace zona::beam
