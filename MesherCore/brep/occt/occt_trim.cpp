#include "brep/occt/occt_trim.h"

#include "brep/occt/askable_parameter.h"
#include "brep/occt/occt_error.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <utility>

namespace mesher {

namespace {

class OcctTrim final : public TrimClassifier
{
public:
    /// What is known of the parameters; periods are 0 where there is none.
    struct Parameters
    {
        Interval boundsU;
        Interval boundsV;
        double periodU = 0.0;
        double periodV = 0.0;
    };

    OcctTrim(std::string entity, const TopoDS_Face& face, const Parameters& parameters)
        : entity_(std::move(entity)),
          face_(face),
          parameters_(parameters),
          classifier_(face, BRep_Tool::Tolerance(face))
    {
    }

    TrimSide classify(Vec2 uv) const override
    {
        if (!isFinite(uv)) return TrimSide::Outside;
        const double u = askableParameter(uv.x, parameters_.boundsU, parameters_.periodU);
        const double v = askableParameter(uv.y, parameters_.boundsV, parameters_.periodV);
        switch (asked(entity_, [&] { return classifier_.Perform({u, v}); })) {
            case TopAbs_IN: return TrimSide::Inside;
            case TopAbs_OUT: return TrimSide::Outside;
            default: return TrimSide::OnBoundary;
        }
    }
    std::unique_ptr<TrimClassifier> clone() const override
    {
        return asked(entity_, [&] { return std::make_unique<OcctTrim>(entity_, face_, parameters_); });
    }

private:
    std::string entity_;
    TopoDS_Face face_;
    Parameters parameters_;
    BRepTopAdaptor_FClass2d classifier_;
};

}  // namespace

std::shared_ptr<const TrimClassifier> makeTrim(const std::string& entity, const TopoDS_Face& face,
                                               const BrepFace& own)
{
    const OcctTrim::Parameters parameters = {own.boundsU, own.boundsV, own.surface->periodU(),
                                             own.surface->periodV()};
    return std::make_shared<OcctTrim>(entity, TopoDS::Face(face.Oriented(TopAbs_FORWARD)), parameters);
}

}  // namespace mesher
