#include "app/dialogs/settings_dialog.h"

#include "app/dialogs/colour_page.h"
#include "app/dialogs/pen_page.h"
#include "app/session/settings/languages.h"
#include "app/session/settings/motion.h"
#include "app/session/settings/settings.h"
#include "app/widgets/habits/help_page.h"
#include "app/widgets/habits/mnemonics.h"
#include "app/widgets/look/reduced_motion.h"
#include "app/widgets/look/theme.h"
#include "model/formats/atomic_save.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

namespace suffuse {

SettingsDialog::SettingsDialog(QWidget *parent, const Brush &brush)
    : QDialog(parent), m_themeBefore(int(settings::theme()))
{
    setWindowTitle(tr("Settings"));
    setHelpPage(*this, "window");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(16);
    auto *pages = new QTabWidget(this);
    column->addWidget(pages);
    auto *general = new QWidget(this);
    auto *page = new QVBoxLayout(general);
    page->setContentsMargins(12, 12, 12, 12);
    page->setSpacing(16);
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    page->addLayout(form);

    m_language = addCombo(*form, tr("Language"), tr("Language of the program"));
    m_language->addItem(tr("System"), QString());
    for (const Language &each : languages())
        m_language->addItem(each.name, each.code);
    m_language->setCurrentIndex(std::max(0, m_language->findData(settings::language())));

    m_theme = addCombo(*form, tr("Theme"), tr("Colours of the windows"));
    m_theme->addItems({tr("System"), tr("Dark"), tr("Light")});
    m_theme->setCurrentIndex(m_themeBefore);
    connect(m_theme, &QComboBox::currentIndexChanged, this, [](int index) {
        settings::setTheme(settings::Theme(index));
        applyTheme();
    });

    addMotion(*form);
    addDrawing(*form);
    addSaving(*form);
    page->addStretch(1);
    pages->addTab(general, tr("General"));
    m_pen = new PenPage(settings::penSettings(), brush, this);
    pages->addTab(m_pen, tr("Pen"));
    m_colours = new ColourPage(settings::colours(), this);
    pages->addTab(m_colours, tr("Colours"));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &SettingsDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &SettingsDialog::reject);
    column->addWidget(buttons);
    giveMnemonics(*this);
    setMinimumWidth(360);
}

/// It is followed at once, as the theme is, and comes back with Cancel.
void SettingsDialog::addMotion(QFormLayout &form)
{
    const settings::Motion before = settings::motion();
    const auto follow = [](settings::Motion motion) {
        settings::setMotion(motion);
        applyMotion();
    };
    QComboBox *motion = addCombo(form, tr("Motion"), tr("Whether docks glide to their places and carets blink"));
    motion->addItems({tr("System"), tr("Reduced"), tr("Full")});
    motion->setCurrentIndex(int(before));
    connect(motion, &QComboBox::currentIndexChanged, this, [follow](int index) { follow(settings::Motion(index)); });
    connect(this, &QDialog::rejected, this, [before, follow] { follow(before); });
}

/// The page for the canvas: what computes its picture, and with how many threads.
void SettingsDialog::addDrawing(QFormLayout &form)
{
    m_presenter = addCombo(form, tr("Canvas"), tr("How the picture comes to the screen"));
    m_presenter->addItems({tr("Automatic"), tr("Raster"), QStringLiteral("OpenGL")});
    m_presenter->setCurrentIndex(int(settings::presenter()));

    m_backend = addCombo(form, tr("Renderer"), tr("What computes the picture"));
    m_backend->addItem(tr("Automatic"), int(Backend::Auto));
    m_backend->addItem(QStringLiteral("CPU"), int(Backend::Cpu));
    m_backend->addItem(QStringLiteral("CUDA"), int(Backend::Cuda));
    m_backend->setCurrentIndex(std::max(0, m_backend->findData(int(settings::backend()))));

    m_threads = new QSpinBox(this);
    m_threads->setRange(0, 256);
    m_threads->setSpecialValueText(tr("All cores"));
    m_threads->setValue(settings::threads());
    m_threads->setAccessibleName(tr("Threads"));
    m_threads->setToolTip(tr("Processor threads for drawing"));
    form.addRow(tr("Threads"), m_threads);
}

void SettingsDialog::addSaving(QFormLayout &form)
{
    m_backups = new QSpinBox(this);
    m_backups->setRange(0, mostBackups);
    m_backups->setSpecialValueText(tr("None"));
    m_backups->setValue(settings::backups());
    m_backups->setAccessibleName(tr("Backups"));
    m_backups->setToolTip(
        tr("How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the "
           "last one, “~2” the one before. File ▸ Restore Backup brings one back."));
    form.addRow(tr("Backups"), m_backups);
}

QComboBox *SettingsDialog::addCombo(QFormLayout &form, const QString &name, const QString &tip)
{
    auto *combo = new QComboBox(this);
    combo->setAccessibleName(name);
    combo->setToolTip(tip);
    form.addRow(name, combo);
    return combo;
}

void SettingsDialog::accept()
{
    const auto builtBy = [] {
        return std::tuple(settings::language(), settings::presenter(), settings::backend(), settings::threads());
    };
    const auto before = builtBy();
    settings::setLanguage(m_language->currentData().toString());
    settings::setPresenter(settings::Presenter(m_presenter->currentIndex()));
    settings::setBackend(Backend(m_backend->currentData().toInt()));
    settings::setThreads(m_threads->value());
    settings::setBackups(m_backups->value());
    settings::setPenSettings(m_pen->settings());
    settings::setColours(m_colours->settings());
    settings::store().sync();
    m_needsOtherWindows = builtBy() != before;
    QDialog::accept();
}

void SettingsDialog::reject()
{
    if (int(settings::theme()) != m_themeBefore) {
        settings::setTheme(settings::Theme(m_themeBefore));
        applyTheme();
    }
    QDialog::reject();
}

} // namespace suffuse
