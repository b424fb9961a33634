#pragma once

#include "app/widgets/brush_preview.h"

#include <QDialog>
#include <QTimer>

#include <array>
#include <functional>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;
class QVBoxLayout;

namespace suffuse {

class ColourSwatch;
class Editor;
class HintLabel;
class ResponseEditor;
class SliderField;
struct FieldSpec;

/// All settings of the brush in hand, with a stroke of it; what is changed is painted with at once.
class BrushDialog : public QDialog {
    Q_OBJECT

public:
    explicit BrushDialog(Editor &editor, QWidget *parent = nullptr);

    QTableWidget *curves() const { return m_curves; }
    ResponseEditor *curve() const { return m_curve; }
    QComboBox *style() const { return m_style; }
    SliderField *field(const QString &name) const; ///< by its label; null if there is none
    QImage previewImage() const { return m_image; }

signals:
    void saveWanted();
    void saveAsNewWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    using Get = std::function<double(const Brush &)>;
    using Set = std::function<void(Brush &, double)>;
    /// A field and the value that it shows.
    struct Bound {
        SliderField *field;
        QString name;
        Get get;
    };

    void addButtons(QVBoxLayout &column);
    QWidget *makePage(QVBoxLayout *&column);
    QWidget *makePaintPage();
    QWidget *makeCurvesPage();
    QWidget *makeColourPage();
    QWidget *makeHandPage();
    void addValues(QGridLayout &grid);
    void makeTable(QWidget *page);
    void addHand(QVBoxLayout &column, QWidget *page);
    void bind(QGridLayout &grid, const FieldSpec &spec, const Get &get, const Set &set);
    void change(const std::function<void(Brush &)> &apply);
    void chooseStyle(int kind);
    void cellChanged(QTableWidgetItem *item);
    void showCell();
    void refresh();
    void drawPreview();

    Editor &m_editor;
    BrushPreview m_preview;
    QImage m_image;
    QTimer m_drawSoon;
    QLabel *m_picture = nullptr;
    std::vector<Bound> m_bound;
    std::array<SliderField *, 3> m_xi{};
    SliderField *m_beta = nullptr;
    SliderField *m_strength = nullptr;
    SliderField *m_string = nullptr;
    QComboBox *m_style = nullptr;
    QComboBox *m_mix = nullptr;
    QComboBox *m_stabiliser = nullptr;
    QCheckBox *m_followsPath = nullptr;
    QCheckBox *m_jitterAlong = nullptr;
    ColourSwatch *m_second = nullptr;
    QTableWidget *m_curves = nullptr;
    ResponseEditor *m_curve = nullptr;
    HintLabel *m_hint = nullptr;
    QPushButton *m_save = nullptr;
};

} // namespace suffuse
