#pragma once

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace mesher::gui {

/// Form of a mesh object: sizes in, Mesh and Cancel, progress out. It meshes nothing itself and knows nothing of FreeCAD: who
/// shows it listens to its signals and sets its properties, which works the same from Python.
class MeshPanel : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(double size READ size WRITE setSize)  ///< millimetres, 0 for none
    Q_PROPERTY(double minSize READ minSize WRITE setMinSize)
    Q_PROPERTY(int curvature READ curvature WRITE setCurvature)  ///< elements in a full turn, 0 for none
    Q_PROPERTY(bool running READ isRunning WRITE setRunning)
    Q_PROPERTY(QString stage READ stage WRITE setStage)
    Q_PROPERTY(double fraction READ fraction WRITE setFraction)  ///< of the stage, 0 to 1

public:
    explicit MeshPanel(QWidget* parent = nullptr);

    [[nodiscard]] double size() const;
    void setSize(double value);
    [[nodiscard]] double minSize() const;
    void setMinSize(double value);
    [[nodiscard]] int curvature() const;
    void setCurvature(int value);
    [[nodiscard]] bool isRunning() const { return isRunning_; }
    void setRunning(bool running);
    [[nodiscard]] QString stage() const;
    void setStage(const QString& text);
    [[nodiscard]] double fraction() const;
    void setFraction(double value);

Q_SIGNALS:
    void meshRequested();
    void cancelRequested();

private:
    void layOut();

    QDoubleSpinBox* size_;
    QDoubleSpinBox* minSize_;
    QSpinBox* curvature_;
    QPushButton* mesh_;
    QPushButton* cancel_;
    QProgressBar* progress_;
    QLabel* stage_;
    bool isRunning_ = false;
};

}  // namespace mesher::gui
