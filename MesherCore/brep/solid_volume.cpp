#include "brep/solid_volume.h"

#include "brep/face_integral.h"

#include <cmath>

namespace mesher {

namespace {

/// Of a part of a surface: its vector area, and the volume of the cone from the origin over it.
struct Flux
{
    Vec3 area;
    double cone = 0.0;

    friend Flux operator+(const Flux& a, const Flux& b) { return {a.area + b.area, a.cone + b.cone}; }
    friend Flux operator*(double s, const Flux& a) { return {s * a.area, s * a.cone}; }
};

Flux fluxThrough(const BrepModel& model, const BrepFace& face, const Vec3& origin)
{
    // One panel is exact on planes; four suffice for a full turn.
    const int panels = face.surface->kind() == SurfaceKind::Plane ? 1 : 4;
    return faceIntegral(model, face, panels, [&](const SurfacePoint& point) {
        const Vec3 normal = point.normal();
        return Flux{normal, dot(point.position - origin, normal) / 3.0};
    });
}

}  // namespace

SolidVolume volumeOf(const BrepModel& model)
{
    const Vec3 origin = 0.5 * (model.box.low + model.box.high);
    IdVector<BrepFaceId, Flux> fluxes(model.faces.size());
    for (std::uint32_t i = 0; i < model.faces.size(); ++i)
        fluxes[BrepFaceId(i)] = fluxThrough(model, model.faces[BrepFaceId(i)], origin);
    SolidVolume volume;
    for (std::uint32_t i = 0; i < model.solids.size(); ++i) {
        for (const BrepShell& shell : model.solids[BrepSolidId(i)].shells) {
            Flux sum;
            for (const BrepShellFace& face : shell.faces)
                sum = sum + (face.isReversed ? -1.0 : 1.0) * fluxes[face.face];
            volume.value += sum.cone;
            volume.uncertainty += length(sum.area) * length(model.box.extent()) / 3.0;
        }
    }
    return volume;
}

}  // namespace mesher
