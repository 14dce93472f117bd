#include "local_size_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <utility>

namespace mesher::gui {

namespace {

constexpr int kTableHeight = 92;  // pixels: three rows and the header
constexpr int kTableWidth = 120;  // pixels, at least

}  // namespace

LocalSizeTable::LocalSizeTable(QuantityFieldMaker makeField, QWidget* parent)
    : QWidget(parent),
      makeField_(std::move(makeField)),
      table_(new QTableWidget(0, 2, this)),
      remove_(new QPushButton(tr("Remove"), this))
{
    table_->setObjectName(QStringLiteral("localSizes"));
    table_->setHorizontalHeaderLabels({tr("Local size of"), tr("Size")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->hide();
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setFixedHeight(kTableHeight);
    table_->setMinimumWidth(kTableWidth);
    table_->hide();
    auto* add = new QPushButton(tr("Add local size"), this);
    add->setObjectName(QStringLiteral("addLocalSize"));
    add->setToolTip(
        tr("Gives the faces, edges and vertices that are selected in the view a size of their own"));
    remove_->setObjectName(QStringLiteral("removeLocalSize"));
    remove_->setEnabled(false);
    connect(add, &QPushButton::clicked, this, &LocalSizeTable::selectionWanted);
    connect(remove_, &QPushButton::clicked, this, &LocalSizeTable::removeCurrent);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(add);
    buttons->addWidget(remove_);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(table_);
    all->addLayout(buttons);
}

QVariantMap LocalSizeTable::sizes() const
{
    QVariantMap sizes;
    for (int row = 0; row < table_->rowCount(); ++row) {
        const auto* length = qobject_cast<LengthField*>(table_->cellWidget(row, 1));
        if (length->value() > 0.0) sizes.insert(table_->item(row, 0)->text(), length->value());
    }
    return sizes;
}

void LocalSizeTable::setSizes(const QVariantMap& sizes)
{
    table_->setRowCount(0);
    showIfFilled();
    for (auto it = sizes.begin(); it != sizes.end(); ++it) addRow(it.key(), it.value().toDouble());
}

void LocalSizeTable::addRow(const QString& name, double size)
{
    const int row = table_->rowCount();
    table_->insertRow(row);
    auto* item = new QTableWidgetItem(name);
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    table_->setItem(row, 0, item);
    auto* length = new LengthField(makeField_, QStringLiteral("localSizeOf") + name, tr("none"), table_);
    length->setValue(size);
    connect(length, &LengthField::valueChanged, this, &LocalSizeTable::sizesChanged);
    table_->setCellWidget(row, 1, length);
    showIfFilled();
}

void LocalSizeTable::showIfFilled()
{
    table_->setVisible(table_->rowCount() > 0);
    remove_->setEnabled(table_->rowCount() > 0);
}

void LocalSizeTable::removeCurrent()
{
    const int row = table_->currentRow() >= 0 ? table_->currentRow() : table_->rowCount() - 1;
    if (row < 0) return;
    table_->removeRow(row);
    showIfFilled();
    Q_EMIT sizesChanged();
}

}  // namespace mesher::gui
