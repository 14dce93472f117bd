#include "brep/model_measures.h"

#include "brep/face_integral.h"

#include <cmath>

namespace mesher {

namespace {

/// Of a part of a surface: its area and vector area, and the volume of the cone from the origin over it.
struct Flux
{
    double area = 0.0;
    Vec3 vectorArea;
    double cone = 0.0;

    friend Flux operator+(const Flux& a, const Flux& b)
    {
        return {a.area + b.area, a.vectorArea + b.vectorArea, a.cone + b.cone};
    }
    friend Flux operator*(double s, const Flux& a) { return {s * a.area, s * a.vectorArea, s * a.cone}; }
};

Flux fluxThrough(const BrepModel& model, const BrepFace& face, const Vec3& origin)
{
    return faceIntegral(model, face, [&](const SurfacePoint& point) {
        const Vec3 normal = point.normal();
        return Flux{length(normal), normal, dot(point.position - origin, normal) / 3.0};
    });
}

SolidVolume volumeOf(const BrepModel& model, const IdVector<BrepFaceId, Flux>& fluxes)
{
    SolidVolume volume;
    for (const BrepSolid& solid : model.solids) {
        for (const BrepShell& shell : solid.shells) {
            Flux sum;
            for (const BrepShellFace& face : shell.faces)
                sum = sum + (face.isReversed ? -1.0 : 1.0) * fluxes[face.face];
            volume.value += sum.cone;
            volume.uncertainty += length(sum.vectorArea) * length(model.box.extent()) / 3.0;
        }
    }
    return volume;
}

}  // namespace

double ModelMeasures::area() const
{
    double sum = 0.0;
    for (const double area : areaOf) sum += area;
    return sum;
}

ModelMeasures measureModel(const BrepModel& model, RunContext& context)
{
    const Vec3 origin = 0.5 * (model.box.low + model.box.high);
    IdVector<BrepFaceId, Flux> fluxes(model.faces.size());
    ModelMeasures measures;
    for (std::uint32_t i = 0; i < model.faces.size() && context.mayGoOn(); ++i)
        fluxes[BrepFaceId(i)] = fluxThrough(model, model.faces[BrepFaceId(i)], origin);
    for (const Flux& flux : fluxes) measures.areaOf.push_back(std::abs(flux.area));
    measures.volume = volumeOf(model, fluxes);
    return measures;
}

}  // namespace mesher
