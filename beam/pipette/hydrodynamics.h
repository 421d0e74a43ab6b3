#pragma once

#include <complex>

namespace zona::beam {

/// A viscous liquid around or in the pipette.
struct Liquid {
  double density = 1000;      ///< [kg/m^3]
  double viscosity = 8.9e-4;  ///< [Pa s]; water at 25 degrees Celsius
};

/// Flow of a liquid past a moving wall.
enum class Flow {
  across,  ///< around a cylinder that moves across its axis
  along,   ///< around a cylinder that moves along its axis
  within,  ///< in the bore of a tube that moves along its axis, driven by the wall only
};

/// lambda K1(lambda) / K0(lambda) of the modified Bessel functions, for |arg lambda| <= pi/4: the
/// Stokes layer around a cylinder of radius a, with lambda = a sqrt(s rho / eta) in the Laplace
/// variable s. Trapezoidal rule for K_n(z) = int_0^inf exp(-z cosh t) cosh(n t) dt, whose error
/// falls exponentially; relative error 1e-13.
std::complex<double> outer_ratio(std::complex<double> lambda);

/// lambda I1(lambda) / I0(lambda), for |arg lambda| <= pi/4: the Stokes layer in a bore. Continued
/// fraction, or asymptotic series for large |lambda|; relative error 1e-11.
std::complex<double> bore_ratio(std::complex<double> lambda);

/// Viscous force per length and velocity [Pa s] in the Laplace variable s [1/s] on a wall of this
/// radius [m], with lambda as above: 4 pi eta `outer_ratio` across, without the inertia rho pi a^2
/// s of an inviscid liquid (Sader, J. Appl. Phys. 84, 64, 1998, eq. 20); 2 pi eta `outer_ratio`
/// along; 2 pi eta `bore_ratio` within, i.e. s times the share 2 I1/(lambda I0) of the liquid's
/// mass that follows the wall.
std::complex<double> viscous_load(Flow flow, const Liquid& liquid, double radius,
                                  std::complex<double> s);

}  // namespace zona::beam
