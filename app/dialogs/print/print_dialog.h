#pragma once

#include "app/dialogs/export/export_rows.h"
#include "app/dialogs/export/exporting_dialog.h"
#include "app/dialogs/print/print_job.h"

#include <QTimer>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSpinBox;

namespace suffuse {

class Editor;
class SheetView;

/// Prints the painting, or writes it as a PDF page, and shows the sheet as it will be. It begins with the page that the
/// document keeps.
class PrintDialog : public ExportingDialog {
    Q_OBJECT

public:
    /// `shown` is the part of the canvas that the window shows.
    PrintDialog(Editor &editor, const Rect &shown, QWidget *parent = nullptr);

    /// Takes nearly all of the screen, to look at the sheet.
    void enlarge();

    PrintSetup setup() const;
    void take(const PrintSetup &setup);
    PagePlan plan() const;
    /// With how many dots an inch it is printed.
    int dpi() const;
    /// Whether a PDF file is chosen, and no printer.
    bool printsToFile() const;

    QComboBox *printer() const { return m_printer; }
    QComboBox *paper() const { return m_paper; }
    QComboBox *orientation() const { return m_orientation; }
    const std::array<QDoubleSpinBox *, 4> &margins() const { return m_margins; }
    QComboBox *sizeBox() const { return m_size; }
    QDoubleSpinBox *scale() const { return m_scale; }
    AreaRow *area() const { return m_area; }
    MomentRow *moment() const { return m_moment; }
    QComboBox *resolution() const { return m_resolution; }
    QCheckBox *background() const { return m_background; }
    QLabel *said() const { return m_said; }
    SheetView *page() const { return m_page; }
    bool isExporting() const override { return m_job.isPrinting(); }

private:
    void addFields(QGridLayout &grid, const Rect &shown);
    void addPrinters(QGridLayout &grid);
    void addPaper();
    /// How large the painting's own sheet is on paper, mm.
    QSizeF sheet() const;
    void paperChanged();
    void addMargins(QGridLayout &grid);
    void addSize(QGridLayout &grid);
    void addResolution();
    void follow();
    void chooseDpi(int dpi);
    PageOrder order() const;
    void printerChanged();
    void settingsChanged();
    void changeSoon();
    void showSheet();
    void sayOutcome();
    void browse() override;
    void pathChanged() override;
    void startExport() override;
    void stop() override { m_job.cancel(); }
    void remember() override;
    void setBusy(bool busy) override;

    Editor &m_editor;
    PrintJob m_job;
    QTimer m_soon; ///< until what is being typed is shown
    QComboBox *m_printer = nullptr;
    QLabel *m_noPrinter = nullptr;
    QSpinBox *m_copies = nullptr;
    QComboBox *m_paper = nullptr;
    QComboBox *m_orientation = nullptr;
    std::array<QDoubleSpinBox *, 4> m_margins{};
    bool m_isOnOwnSheet = false;
    std::array<double, 4> m_otherMargins = PrintSetup{}.margins; ///< of paper that is not the painting's own sheet
    QComboBox *m_size = nullptr;
    QDoubleSpinBox *m_scale = nullptr;
    AreaRow *m_area = nullptr;
    MomentRow *m_moment = nullptr;
    QComboBox *m_resolution = nullptr;
    QCheckBox *m_background = nullptr;
    QLabel *m_said = nullptr;
    SheetView *m_page = nullptr;
    std::vector<int> m_printerDpi; ///< of each printer in the list, the finest
};

} // namespace suffuse
