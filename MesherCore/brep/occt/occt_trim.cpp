#include "brep/occt/occt_trim.h"

#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

namespace mesher {

namespace {

class OcctTrim final : public TrimClassifier
{
public:
    explicit OcctTrim(const TopoDS_Face& face) : face_(face), classifier_(face, BRep_Tool::Tolerance(face)) {}

    TrimSide classify(Vec2 uv) const override
    {
        switch (classifier_.Perform({uv.x, uv.y})) {
            case TopAbs_IN: return TrimSide::Inside;
            case TopAbs_OUT: return TrimSide::Outside;
            default: return TrimSide::OnBoundary;
        }
    }
    std::unique_ptr<TrimClassifier> clone() const override { return std::make_unique<OcctTrim>(face_); }

private:
    TopoDS_Face face_;
    BRepTopAdaptor_FClass2d classifier_;
};

}  // namespace

std::shared_ptr<const TrimClassifier> makeTrim(const TopoDS_Face& face)
{
    return std::make_shared<OcctTrim>(TopoDS::Face(face.Oriented(TopAbs_FORWARD)));
}

}  // namespace mesher
