#pragma once

#include "mpm/points/lanes.h"

namespace zona::mpm {

/// Tensor components in a plane, of one point (T = double) or eight (T = Lanes).
template <class T>
struct PlaneValues {
  T xx;  ///< normal, along x
  T yy;  ///< normal, along y
  T xy;  ///< of the tensor: half the engineering shear strain
};

/// Components at one point.
using PlaneTensor = PlaneValues<double>;
/// Components at eight points.
using InPlane = PlaneValues<Lanes>;

/// @{
/// Component by component.
template <class T>
inline PlaneValues<T> operator+(const PlaneValues<T>& a, const PlaneValues<T>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
}
template <class T>
inline PlaneValues<T> operator-(const PlaneValues<T>& a, const PlaneValues<T>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}
template <class T>
inline PlaneValues<T> operator*(const T& factor, const PlaneValues<T>& a) {
  return {factor * a.xx, factor * a.yy, factor * a.xy};
}
/// @}
/// a : b
template <class T>
inline T contract(const PlaneValues<T>& a, const PlaneValues<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + 2.0 * a.xy * b.xy;
}

/// Principal values, first >= second, and the direction of the first: cos and sin of twice its
/// angle.
template <class T>
struct PrincipalValues {
  T first;   ///< larger value
  T second;  ///< smaller value
  T cos2;    ///< cosine of twice the angle of the first direction to x [-]
  T sin2;    ///< sine of the same angle [-]
};

/// Principal values at eight points.
using Principal = PrincipalValues<Lanes>;

/// Principal values of a tensor in the plane (4.22)-(4.24). If both are equal, the first one has
/// the direction x.
template <class T>
inline PrincipalValues<T> principal_values(const PlaneValues<T>& a) {
  const T one = T{} + 1.0;
  const T mean = 0.5 * (a.xx + a.yy);
  const T half = 0.5 * (a.xx - a.yy);
  const T radius = square_root(half * half + a.xy * a.xy);
  const auto turned = radius > 0.0;
  const T scale = 1.0 / select(turned, radius, one);
  return {mean + radius, mean - radius, select(turned, half * scale, one), a.xy * scale};
}

/// @{
/// `principal_values` of eight points or one.
inline Principal principal(const InPlane& a) {
  return principal_values(a);
}
inline PrincipalValues<double> principal(const PlaneTensor& a) {
  return principal_values(a);
}
/// @}

/// The tensor that has these principal values (4.25)-(4.27).
template <class T>
inline PlaneValues<T> in_axes(const PrincipalValues<T>& p) {
  const T mean = 0.5 * (p.first + p.second);
  const T radius = 0.5 * (p.first - p.second);
  return {mean + radius * p.cos2, mean - radius * p.cos2, radius * p.sin2};
}

}  // namespace zona::mpm
