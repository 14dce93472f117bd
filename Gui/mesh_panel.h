#pragma once

#include "length_field.h"

#include <QVariantList>
#include <QVariantMap>
#include <QWidget>

class QCheckBox;
class QGroupBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace mesher::gui {

class LocalSizeTable;
class QualityHistogram;

/// Form of a mesh object: sizes in, an estimate, Mesh and Stop, progress and what came out. It meshes nothing itself and knows
/// nothing of FreeCAD: who shows it listens to its signals and sets its properties, which works the same from Python.
class MeshPanel : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(double size READ size WRITE setSize)  ///< millimetres, 0 for none; so are the other lengths
    Q_PROPERTY(double minSize READ minSize WRITE setMinSize)
    Q_PROPERTY(int curvature READ curvature WRITE setCurvature)  ///< elements in a full turn, 0 for none
    Q_PROPERTY(double sag READ sag WRITE setSag)
    Q_PROPERTY(bool improve READ isImproved WRITE setImproved)
    Q_PROPERTY(QString overlap READ overlap WRITE setOverlap)
    Q_PROPERTY(QVariantMap localSizes READ localSizes WRITE setLocalSizes)  ///< name to millimetres
    /// Whether lengths are properties of a document object; they have to be let go before it is deleted.
    Q_PROPERTY(bool bound READ isBound WRITE setBound)
    Q_PROPERTY(QString estimate READ estimate WRITE setEstimate)
    Q_PROPERTY(bool running READ isRunning WRITE setRunning)
    Q_PROPERTY(QString stage READ stage WRITE setStage)
    Q_PROPERTY(
        double fraction READ fraction WRITE setFraction)  ///< of the stage, 0 to 1; stays when the run ends
    Q_PROPERTY(QString summary READ summary WRITE setSummary)  ///< rich text; empty hides the result
    Q_PROPERTY(QVariantList histogram READ histogram WRITE setHistogram)

public:
    explicit MeshPanel(const QuantityFieldMaker& makeField, QWidget* parent = nullptr);

    [[nodiscard]] double size() const;
    void setSize(double value);
    [[nodiscard]] double minSize() const;
    void setMinSize(double value);
    [[nodiscard]] int curvature() const;
    void setCurvature(int value);
    [[nodiscard]] double sag() const;
    void setSag(double value);
    [[nodiscard]] bool isImproved() const;
    void setImproved(bool value);
    /// "separate" or "refuse".
    [[nodiscard]] QString overlap() const;
    void setOverlap(const QString& value);
    [[nodiscard]] QVariantMap localSizes() const;
    void setLocalSizes(const QVariantMap& sizes);
    [[nodiscard]] bool isBound() const;
    void setBound(bool bound);
    [[nodiscard]] QString estimate() const;
    void setEstimate(const QString& text);
    [[nodiscard]] bool isRunning() const { return isRunning_; }
    void setRunning(bool running);
    [[nodiscard]] QString stage() const;
    void setStage(const QString& text);
    [[nodiscard]] double fraction() const;
    void setFraction(double value);
    [[nodiscard]] QString summary() const;
    void setSummary(const QString& text);
    [[nodiscard]] QVariantList histogram() const;
    void setHistogram(const QVariantList& counts);

Q_SIGNALS:
    void meshRequested();
    void cancelRequested();
    void optionsChanged();
    void selectionWanted();
    void placeWanted(int number);  ///< that a link of the summary names

private:
    [[nodiscard]] QGroupBox* sizeGroup();
    [[nodiscard]] QGroupBox* runGroup();
    [[nodiscard]] QGroupBox* makeResultGroup();
    void connectAll();
    void showWhetherBusy();

    LengthField* size_;
    LengthField* minSize_;
    QSpinBox* curvature_;
    LengthField* sag_;
    QCheckBox* improve_;
    QCheckBox* overlap_;
    LocalSizeTable* localSizes_;
    QLabel* estimate_;
    QPushButton* mesh_;
    QPushButton* cancel_;
    QProgressBar* progress_;
    QLabel* stage_;
    QLabel* summary_;
    QualityHistogram* histogram_;
    QGroupBox* sizes_;
    QGroupBox* result_;
    bool isRunning_ = false;
};

}  // namespace mesher::gui
