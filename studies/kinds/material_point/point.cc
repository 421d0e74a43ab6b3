#include "studies/kinds/material_point/point.h"

#include "studies/kinds/material_point/material_table.h"
#include "studies/parameters/material_tables.h"

namespace zona::studies {

namespace {

/// The law of the point, as one of solids or of membranes.
template <class Law>
Law law_of(const Configuration& study, const PointMaterial& material) {
  switch (material.law) {
    case LawName::elastic:
      return mpm::Elastic{};
    case LawName::elastodamage:
      return study.read<mpm::Elastodamage>();
    case LawName::von_mises:
    case LawName::decohesion:
      break;
  }
  return plastic_law(study.table<PointMaterial>(), material.law == LawName::decohesion,
                     Eigen::Vector3d::Constant(material.cell));
}

}  // namespace

mpm::SinglePoint material_point(const Configuration& study) {
  const auto material = study.read<PointMaterial>();
  if (material.geometry == PointGeometry::solid) {
    return {mpm::ElasticModuli{material.youngs_modulus, material.poisson_ratio},
            law_of<mpm::SolidLaw>(study, material)};
  }
  const auto options = study.read<MembraneOptions>();
  const mpm::MembraneProperties properties{1000, 1, material.youngs_modulus, material.poisson_ratio,
                                           options.one_way};
  if (material.law == LawName::elastic) return {properties, options.elastic_law()};
  return {properties, law_of<mpm::MembraneLaw>(study, material)};
}

}  // namespace zona::studies
