#pragma once

#include "app/widgets/brush/brush_preview.h"

#include <QDialog>
#include <QTimer>

#include <array>
#include <functional>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QVBoxLayout;

namespace suffuse {

class BrushCurvesPage;
class BrushPage;
class BrushPaintPage;
class Editor;
class HintLabel;
class ResponseEditor;
class SliderField;

/// Shows all settings of the brush in hand, and a stroke of it. The brush in hand takes each change at once.
class BrushDialog : public QDialog {
    Q_OBJECT

public:
    explicit BrushDialog(Editor &editor, QWidget *parent = nullptr);

    QTableWidget *curves() const;
    ResponseEditor *curve() const;
    QComboBox *style() const;
    SliderField *field(const QString &name) const; ///< by its label; null if there is none
    QImage previewImage() const { return m_image; }

signals:
    void saveWanted();
    void saveAsNewWanted();

protected:
    void changeEvent(QEvent *event) override;

private:
    void addButtons(QVBoxLayout &column);
    void change(const std::function<void(Brush &)> &apply);
    void refresh();
    void drawPreview();

    Editor &m_editor;
    BrushPreview m_preview;
    QImage m_image;
    QTimer m_drawSoon;
    QLabel *m_picture = nullptr;
    BrushPaintPage *m_paint = nullptr;
    BrushCurvesPage *m_curves = nullptr;
    std::array<BrushPage *, 4> m_pages{}; ///< in the order of the tabs
    HintLabel *m_hint = nullptr;
    QPushButton *m_save = nullptr;
};

} // namespace suffuse
