#include "mesh_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
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
constexpr int kSmallestInputWidth = 80;  // pixels

QDoubleSpinBox* lengthBox(const QString& name, const QString& none, QWidget* parent)
{
    auto* box = new QDoubleSpinBox(parent);
    box->setObjectName(name);
    box->setDecimals(4);
    box->setRange(0.0, 1e7);
    box->setSuffix(QStringLiteral(" mm"));
    box->setSpecialValueText(none);
    // The widest number that fits is no reason for a panel wider than FreeCAD's.
    box->setMinimumWidth(kSmallestInputWidth);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    return box;
}

}  // namespace

MeshPanel::MeshPanel(QWidget* parent)
    : QWidget(parent),
      size_(lengthBox(QStringLiteral("size"), tr("automatic"), this)),
      minSize_(lengthBox(QStringLiteral("minSize"), tr("no limit"), this)),
      curvature_(new QSpinBox(this)),
      mesh_(new QPushButton(tr("Mesh"), this)),
      cancel_(new QPushButton(tr("Stop"), this)),
      progress_(new QProgressBar(this)),
      stage_(new QLabel(this))
{
    curvature_->setObjectName(QStringLiteral("curvature"));
    curvature_->setRange(0, 3600);
    curvature_->setMinimumWidth(kSmallestInputWidth);
    curvature_->setSpecialValueText(tr("off"));
    mesh_->setObjectName(QStringLiteral("meshButton"));
    cancel_->setObjectName(QStringLiteral("cancelButton"));
    progress_->setObjectName(QStringLiteral("progress"));
    progress_->setRange(0, kProgressSteps);
    stage_->setObjectName(QStringLiteral("stage"));
    stage_->setWordWrap(true);
    connect(mesh_, &QPushButton::clicked, this, &MeshPanel::meshRequested);
    connect(cancel_, &QPushButton::clicked, this, &MeshPanel::cancelRequested);
    layOut();
    setRunning(false);
}

void MeshPanel::layOut()
{
    auto* form = new QFormLayout;
    form->addRow(tr("Largest size"), size_);
    form->addRow(tr("Smallest size"), minSize_);
    form->addRow(tr("Elements per full turn"), curvature_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(mesh_);
    buttons->addWidget(cancel_);
    auto* all = new QVBoxLayout(this);
    all->addLayout(form);
    all->addLayout(buttons);
    all->addWidget(progress_);
    all->addWidget(stage_);
}

double MeshPanel::size() const { return size_->value(); }
void MeshPanel::setSize(double value) { size_->setValue(value); }
double MeshPanel::minSize() const { return minSize_->value(); }
void MeshPanel::setMinSize(double value) { minSize_->setValue(value); }
int MeshPanel::curvature() const { return curvature_->value(); }
void MeshPanel::setCurvature(int value) { curvature_->setValue(value); }
QString MeshPanel::stage() const { return stage_->text(); }
void MeshPanel::setStage(const QString& text) { stage_->setText(text); }

double MeshPanel::fraction() const
{
    return static_cast<double>(progress_->value()) / static_cast<double>(kProgressSteps);
}

void MeshPanel::setFraction(double value)
{
    progress_->setValue(static_cast<int>(std::lround(value * kProgressSteps)));
}

void MeshPanel::setRunning(bool running)
{
    isRunning_ = running;
    mesh_->setEnabled(!running);
    cancel_->setEnabled(running);
    for (QWidget* input : {static_cast<QWidget*>(size_), static_cast<QWidget*>(minSize_),
                           static_cast<QWidget*>(curvature_)}) {
        input->setEnabled(!running);
    }
    setFraction(0.0);
}

}  // namespace mesher::gui
