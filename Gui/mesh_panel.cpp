#include "mesh_panel.h"

#include "length_field.h"
#include "local_size_table.h"
#include "quality_histogram.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>

namespace mesher::gui {

namespace {

constexpr int kProgressSteps = 1000;
// The widest number that fits is no reason for a panel wider than FreeCAD's.
constexpr int kSmallestInputWidth = 70;  // pixels
constexpr int kGroupMargin = 4;          // pixels
constexpr int kGroupTop = 10;            // pixels, below the title

template <class Widget>
Widget* named(Widget* widget, const char* name)
{
    widget->setObjectName(QLatin1String(name));
    return widget;
}

LengthField* lengthField(const QuantityFieldMaker& make, const char* name, const QString& none,
                         const QString& tip, QWidget* parent)
{
    auto* length = new LengthField(make, QLatin1String(name), none, parent);
    length->field()->setMinimumWidth(kSmallestInputWidth);
    length->setToolTip(tip);
    return length;
}

QLabel* wrappedLabel(const char* name, QWidget* parent)
{
    auto* label = named(new QLabel(parent), name);
    label->setWordWrap(true);
    return label;
}

}  // namespace

MeshPanel::MeshPanel(const QuantityFieldMaker& makeField, QWidget* parent)
    : QWidget(parent),
      size_(lengthField(makeField, "size", tr("auto"),
                        tr("Mean edge where nothing asks for less; units and expressions may be typed: "
                           "1/4 in, =Spreadsheet.width"),
                        this)),
      minSize_(lengthField(makeField, "minSize", tr("off"), tr("No size asked for is to be smaller"), this)),
      curvature_(named(new QSpinBox(this), "curvature")),
      sag_(lengthField(makeField, "sag", tr("off"), tr("Largest distance of an edge from its curve or face"),
                       this)),
      improve_(named(new QCheckBox(tr("Improve afterwards"), this), "improve")),
      overlap_(named(new QCheckBox(tr("Refuse solids that overlap"), this), "refuseOverlap")),
      localSizes_(new LocalSizeTable(makeField, this)),
      estimate_(wrappedLabel("estimate", this)),
      mesh_(named(new QPushButton(tr("Mesh"), this), "meshButton")),
      cancel_(named(new QPushButton(tr("Stop"), this), "cancelButton")),
      progress_(named(new QProgressBar(this), "progress")),
      stage_(wrappedLabel("stage", this)),
      summary_(wrappedLabel("summary", this)),
      histogram_(new QualityHistogram(this)),
      sizes_(sizeGroup()),
      result_(makeResultGroup())
{
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(sizes_);
    all->addWidget(runGroup());
    all->addWidget(result_);
    connectAll();
    setFraction(0.0);
    setRunning(false);
    setSummary({});
}

QGroupBox* MeshPanel::sizeGroup()
{
    curvature_->setRange(0, 3600);
    curvature_->setMinimumWidth(kSmallestInputWidth);
    curvature_->setSpecialValueText(tr("off"));
    curvature_->setToolTip(tr("Elements around a full circle; 12 is coarse, 36 is fine"));
    auto* group = new QGroupBox(tr("Sizes"), this);
    auto* form = new QFormLayout(group);
    form->setContentsMargins(kGroupMargin, kGroupTop, kGroupMargin, kGroupMargin);
    form->addRow(tr("Largest size"), size_);
    form->addRow(tr("Smallest size"), minSize_);
    form->addRow(tr("Elements / turn"), curvature_);
    form->addRow(tr("Chord deviation"), sag_);
    form->addRow(localSizes_);
    form->addRow(improve_);
    overlap_->setToolTip(tr("Solids that overlap end the run, instead of being meshed each for itself"));
    form->addRow(overlap_);
    return group;
}

QGroupBox* MeshPanel::runGroup()
{
    progress_->setRange(0, kProgressSteps);
    auto* group = new QGroupBox(tr("Mesh"), this);
    auto* all = new QVBoxLayout(group);
    all->setContentsMargins(kGroupMargin, kGroupTop, kGroupMargin, kGroupMargin);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(mesh_);
    buttons->addWidget(cancel_);
    all->addWidget(estimate_);
    all->addLayout(buttons);
    all->addWidget(progress_);
    all->addWidget(stage_);
    return group;
}

QGroupBox* MeshPanel::makeResultGroup()
{
    auto* group = new QGroupBox(tr("Result"), this);
    auto* all = new QVBoxLayout(group);
    all->setContentsMargins(kGroupMargin, kGroupTop, kGroupMargin, kGroupMargin);
    summary_->setTextFormat(Qt::RichText);
    connect(summary_, &QLabel::linkActivated, this,
            [this](const QString& link) { Q_EMIT placeWanted(link.toInt()); });
    all->addWidget(summary_);
    all->addWidget(histogram_);
    return group;
}

void MeshPanel::connectAll()
{
    connect(mesh_, &QPushButton::clicked, this, &MeshPanel::meshRequested);
    connect(cancel_, &QPushButton::clicked, this, &MeshPanel::cancelRequested);
    for (LengthField* length : {size_, minSize_, sag_})
        connect(length, &LengthField::valueChanged, this, &MeshPanel::optionsChanged);
    connect(curvature_, QOverload<int>::of(&QSpinBox::valueChanged), this, &MeshPanel::optionsChanged);
    connect(localSizes_, &LocalSizeTable::sizesChanged, this, &MeshPanel::optionsChanged);
    connect(localSizes_, &LocalSizeTable::selectionWanted, this, &MeshPanel::selectionWanted);
}

double MeshPanel::size() const { return size_->value(); }
void MeshPanel::setSize(double value) { size_->setValue(value); }
double MeshPanel::minSize() const { return minSize_->value(); }
void MeshPanel::setMinSize(double value) { minSize_->setValue(value); }
int MeshPanel::curvature() const { return curvature_->value(); }
void MeshPanel::setCurvature(int value) { curvature_->setValue(value); }
double MeshPanel::sag() const { return sag_->value(); }
void MeshPanel::setSag(double value) { sag_->setValue(value); }
bool MeshPanel::isImproved() const { return improve_->isChecked(); }
void MeshPanel::setImproved(bool value) { improve_->setChecked(value); }
QString MeshPanel::overlap() const
{
    return overlap_->isChecked() ? QStringLiteral("refuse") : QStringLiteral("separate");
}
void MeshPanel::setOverlap(const QString& value) { overlap_->setChecked(value == QStringLiteral("refuse")); }
QVariantMap MeshPanel::localSizes() const { return localSizes_->sizes(); }
void MeshPanel::setLocalSizes(const QVariantMap& sizes) { localSizes_->setSizes(sizes); }
bool MeshPanel::isBound() const { return size_->field() != nullptr; }

void MeshPanel::setBound(bool bound)
{
    if (bound) return;
    for (LengthField* length : {size_, minSize_, sag_}) length->letFieldGo();
}

QString MeshPanel::estimate() const { return estimate_->text(); }
void MeshPanel::setEstimate(const QString& text) { estimate_->setText(text); }
QString MeshPanel::stage() const { return stage_->text(); }
void MeshPanel::setStage(const QString& text) { stage_->setText(text); }
QString MeshPanel::summary() const { return summary_->text(); }

void MeshPanel::setSummary(const QString& text)
{
    summary_->setText(text);
    result_->setVisible(!text.isEmpty());
}

QVariantList MeshPanel::histogram() const
{
    QVariantList counts;
    for (const double count : histogram_->counts()) counts.append(count);
    return counts;
}

void MeshPanel::setHistogram(const QVariantList& counts)
{
    QVector<double> numbers;
    for (const QVariant& count : counts) numbers.append(count.toDouble());
    histogram_->setCounts(numbers);
}

double MeshPanel::fraction() const
{
    return static_cast<double>(progress_->value()) / static_cast<double>(kProgressSteps);
}

void MeshPanel::setFraction(double value)
{
    progress_->setValue(static_cast<int>(std::lround(value * kProgressSteps)));
    showWhetherBusy();
}

/// Without a run there is no share of it to tell: an empty bar then has no "0 %" that looks like one that is stuck.
void MeshPanel::showWhetherBusy()
{
    progress_->setEnabled(isRunning_);
    progress_->setTextVisible(isRunning_ || progress_->value() > 0);
}

void MeshPanel::setRunning(bool running)
{
    isRunning_ = running;
    mesh_->setEnabled(!running);
    cancel_->setEnabled(running);
    sizes_->setEnabled(!running);
    if (running) setFraction(0.0);
    showWhetherBusy();
}

}  // namespace mesher::gui
