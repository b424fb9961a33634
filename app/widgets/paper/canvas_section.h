#pragma once

#include "app/widgets/numbers/slider_field.h"
#include "model/painting/painting.h"

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;

namespace suffuse {

class ColourRows;
class ColourSwatch;
class NumberField;

/// A form for the size, background and paper of a canvas. It edits a value: the inspector writes that to the document,
/// and the dialog for new paintings keeps it.
class CanvasSection : public QWidget {
    Q_OBJECT

public:
    explicit CanvasSection(QWidget *parent = nullptr);

    void setCanvas(const Canvas &canvas);
    const Canvas &canvas() const { return m_canvas; }
    /// Says how large the sheet is on paper, where an inch of it has so many units; 0: it is not said.
    void setResolution(double resolution);
    /// Shows and takes the sides in another unit. Those of paper become whole units of the canvas.
    void setSideDisplay(const Display &display, bool isPaper);

    NumberField *widthField() const { return m_width; }
    NumberField *heightField() const { return m_height; }
    QLabel *onPaper() const { return m_onPaper; }
    /// The entries: none, the presets, and an image.
    QComboBox *paperChoice() const { return m_paper; }
    SliderField *paperScale() const { return m_scale; }
    SliderField *paperStrength() const { return m_strength; }
    ColourRows *background() const { return m_background; }

signals:
    /// Emitted with a valid canvas in which one member was changed.
    void edited(const suffuse::Canvas &canvas, const QString &undoText, suffuse::ValueEntry *entry);
    void refused(const QString &hint);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void addSize(QGridLayout &grid);
    void addPaper(QGridLayout &grid);
    void change(const std::function<void(Canvas &)> &change, const QString &undoText, ValueEntry *entry = nullptr);
    void choosePaper(int index);
    void chooseImagePaper();
    void showThumbnails();
    bool chooseImage(Paper &paper);
    void refresh();
    QString sizeOnPaper() const;

    Canvas m_canvas;
    double m_resolution = 0;
    bool m_isPaper = false; ///< whether sides are lengths of paper
    NumberField *m_width = nullptr;
    NumberField *m_height = nullptr;
    QLabel *m_onPaper = nullptr;
    ValueEntry m_widthSteps, m_heightSteps, m_seedSteps; ///< by the arrow keys and the wheel
    ColourSwatch *m_swatch = nullptr;
    ColourRows *m_background = nullptr;
    QComboBox *m_paper = nullptr;
    QPushButton *m_image = nullptr;
    QLabel *m_seedLabel = nullptr;
    NumberField *m_seed = nullptr;
    SliderField *m_scale = nullptr;
    SliderField *m_strength = nullptr;
};

} // namespace suffuse
