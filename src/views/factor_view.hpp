// Tessellation factors as colours.
#pragma once

#include "views/colour_map.hpp"
#include "views/patch_domain.hpp"
#include "views/view.hpp"

namespace tessera::views {

/// The factor that is shown at a domain point in 16.16: factors as the tessellator uses them (PatchDomain::factors). On
/// an edge it is the edge's own, so that both patches of an edge show the same, in the middle of the patch the inside
/// factor (of quads, the mean of the two). Between them the edges' factors are weighed by the inverse distance, as
/// barycentric or square coordinates tell it, and the inside factor has the share 27 uvw (quads: 16 u(1-u) v(1-v)). At
/// a corner it is the mean of the two edges that meet there.
double factor_at(const PatchDomain& domain, const DomainPoint& point);

/// The edges that a domain point lies on: bit i for that of outer factor i.
std::uint32_t edges_of(Domain domain, const DomainPoint& point);

/// The least and the greatest factor of all patches that are not culled, and of hair the number of its segments.
Scale factor_scale(const Subject& subject, const TessellationOptions& options);

/// Draws factors; `fixed` replaces the scale that the factors have. A corner of a patch takes the colour of the edge
/// that a triangle lies along, so that an edge has its colour from end to end. Hair shows the number of its segments.
std::unique_ptr<View> make_factor_view(const Subject& subject, const std::optional<Scale>& fixed);

}  // namespace tessera::views
