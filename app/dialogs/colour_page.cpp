#include "app/dialogs/colour_page.h"

#include "app/widgets/asking/choose_profile.h"
#include "app/widgets/look/section.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace suffuse {

ColourPage::ColourPage(const ColourSettings &settings, QWidget *parent) : QWidget(parent), m_settings(settings)
{
    auto *page = new QVBoxLayout(this);
    page->setContentsMargins(12, 12, 12, 12);
    page->setSpacing(16);
    auto *form = new QFormLayout;
    form->setHorizontalSpacing(16);
    form->setVerticalSpacing(8);
    page->addLayout(form);
    const auto add = [form](const QString &name, QWidget *field, const QString &tip) {
        field->setAccessibleName(name);
        field->setToolTip(tip);
        form->addRow(name, field);
    };

    m_screen = new QComboBox(this);
    m_screen->addItem(tr("That of the system"), int(ScreenProfile::System));
    m_screen->addItem(tr("None (sRGB)"), int(ScreenProfile::None));
    m_screen->addItem(tr("From a file"), int(ScreenProfile::File));
    m_screen->setCurrentIndex(m_screen->findData(int(settings.screen)));
    add(tr("Screen profile"), m_screen,
        tr("What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were "
           "meant."));
    m_screenFile = new QPushButton(this);
    add(tr("Screen profile file"), m_screenFile, tr("Chooses the ICC profile that was measured for this screen"));
    m_proofFile = new QPushButton(this);
    add(tr("Soft proof"), m_proofFile,
        tr("Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left "
           "there."));

    m_intent = new QComboBox(this);
    m_intent->addItem(tr("Perceptual"), int(RenderingIntent::Perceptual));
    m_intent->addItem(tr("Relative colorimetric"), int(RenderingIntent::RelativeColorimetric));
    m_intent->addItem(tr("Saturation"), int(RenderingIntent::Saturation));
    m_intent->addItem(tr("Absolute colorimetric"), int(RenderingIntent::AbsoluteColorimetric));
    m_intent->setCurrentIndex(m_intent->findData(int(settings.intent)));
    add(tr("Rendering intent"), m_intent,
        tr("What becomes of colours that the device of the soft proof does not have"));
    m_blackPoints = new QCheckBox(tr("Black point compensation"), this);
    m_blackPoints->setToolTip(tr("The darkest colour becomes the darkest one that the device has"));
    m_blackPoints->setChecked(settings.blackPoints);
    form->addRow(QString(), m_blackPoints);
    m_hint = quietLabel({}, this);
    m_hint->setWordWrap(true);
    page->addWidget(m_hint);
    page->addStretch(1);

    connect(m_screen, &QComboBox::activated, this, [this] {
        m_settings.screen = ScreenProfile(m_screen->currentData().toInt());
        if (m_settings.screen == ScreenProfile::File && m_settings.screenFile.isEmpty())
            chooseScreen();
        showNames();
    });
    connect(m_screenFile, &QPushButton::clicked, this, [this] {
        chooseScreen();
        showNames();
    });
    connect(m_proofFile, &QPushButton::clicked, this, [this] {
        chooseProof();
        showNames();
    });
    showNames();
}

ColourSettings ColourPage::settings() const
{
    ColourSettings out = m_settings;
    out.intent = RenderingIntent(m_intent->currentData().toInt());
    out.blackPoints = m_blackPoints->isChecked();
    return out;
}

QString ColourPage::ask(const QString &title, const QString &before, bool forScreen)
{
    m_hint->clear();
    const QString path = askForProfile(this, title, before);
    if (path.isEmpty())
        return {};
    ColourSettings tried;
    tried.screen = forScreen ? ScreenProfile::File : ScreenProfile::None;
    tried.screenFile = path;
    tried.proofs = !forScreen;
    tried.proofFile = path;
    if (const Result<ColourConversion> usable = screenConversion(tried, {}); !usable) {
        m_hint->setText(usable.error());
        return {};
    }
    return path;
}

void ColourPage::chooseScreen()
{
    const QString path = ask(tr("Profile of the Screen"), m_settings.screenFile, true);
    if (!path.isEmpty())
        m_settings.screenFile = path, m_settings.screen = ScreenProfile::File;
    else if (m_settings.screenFile.isEmpty())
        m_settings.screen = ScreenProfile::System; // There is nothing to choose from a file.
    m_screen->setCurrentIndex(m_screen->findData(int(m_settings.screen)));
}

void ColourPage::chooseProof()
{
    if (const QString path = ask(tr("Profile of the Soft Proof"), m_settings.proofFile, false); !path.isEmpty())
        m_settings.proofFile = path;
}

void ColourPage::showNames()
{
    const auto show = [](QPushButton &button, const QString &path) {
        button.setText(path.isEmpty() ? tr("Choose…") : titleOfProfileAt(path));
    };
    show(*m_screenFile, m_settings.screenFile);
    show(*m_proofFile, m_settings.proofFile);
    m_screenFile->setEnabled(m_settings.screen == ScreenProfile::File);
}

} // namespace suffuse
