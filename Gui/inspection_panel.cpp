#include "inspection_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHeaderView>
#include <QSlider>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace mesher::gui {

namespace {

constexpr int kSteps = 200;
constexpr int kSmallestTable = 120;  // pixels, both ways

}  // namespace

InspectionPanel::InspectionPanel(QWidget* parent)
    : QWidget(parent),
      axis_(new QComboBox(this)),
      share_(new QSlider(Qt::Horizontal, this)),
      flip_(new QCheckBox(tr("Cut away the other side"), this)),
      table_(new QTableWidget(0, 3, this))
{
    axis_->setObjectName(QStringLiteral("cutAxis"));
    axis_->addItems({tr("No cut"), tr("Across x"), tr("Across y"), tr("Across z")});
    share_->setObjectName(QStringLiteral("cutShare"));
    share_->setRange(0, kSteps);
    share_->setValue(kSteps / 2);
    // A cut of a large mesh takes a moment: it follows when the slider is let go of.
    share_->setTracking(false);
    flip_->setObjectName(QStringLiteral("cutFlip"));
    table_->setObjectName(QStringLiteral("worstElements"));
    table_->setHorizontalHeaderLabels({tr("Smallest"), tr("Largest"), tr("Place")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setMinimumSize(kSmallestTable, kSmallestTable);
    connect(axis_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &InspectionPanel::cutChanged);
    connect(share_, &QSlider::valueChanged, this, &InspectionPanel::cutChanged);
    connect(flip_, &QCheckBox::toggled, this, &InspectionPanel::cutChanged);
    connect(table_, &QTableWidget::itemSelectionChanged, this, &InspectionPanel::worstChosen);
    layOut();
}

void InspectionPanel::layOut()
{
    auto* cut = new QGroupBox(tr("Cut, by whole elements"), this);
    auto* cutLayout = new QVBoxLayout(cut);
    cutLayout->addWidget(axis_);
    cutLayout->addWidget(share_);
    cutLayout->addWidget(flip_);
    auto* worst = new QGroupBox(tr("Worst elements, by angle"), this);
    auto* worstLayout = new QVBoxLayout(worst);
    worstLayout->addWidget(table_);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(cut);
    all->addWidget(worst);
}

int InspectionPanel::axis() const { return axis_->currentIndex() - 1; }
void InspectionPanel::setAxis(int axis) { axis_->setCurrentIndex(axis + 1); }
double InspectionPanel::share() const { return static_cast<double>(share_->value()) / kSteps; }
void InspectionPanel::setShare(double share)
{
    share_->setValue(static_cast<int>(std::lround(share * kSteps)));
}
bool InspectionPanel::isFlipped() const { return flip_->isChecked(); }

void InspectionPanel::setWorst(const QVariantList& rows)
{
    worst_ = rows;
    table_->setRowCount(0);
    for (const QVariant& row : rows) {
        const QVariantList cells = row.toList();
        const int number = table_->rowCount();
        table_->insertRow(number);
        for (int column = 0; column < cells.size() && column < table_->columnCount(); ++column)
            table_->setItem(number, column, new QTableWidgetItem(cells[column].toString()));
    }
}

int InspectionPanel::chosen() const
{
    const QList<QTableWidgetItem*> items = table_->selectedItems();
    return items.isEmpty() ? -1 : items.front()->row();
}

}  // namespace mesher::gui
