<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Datei</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Bearbeiten</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/context_menu.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Element</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Ansicht</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/palette_entries.py, the menus]</extracomment>
   <translation>Kamera</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Hilfe</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} Element, Symmetrien: {turns}</numerusform>
    <numerusform>{n} Elemente, Symmetrien: {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Es gibt noch kein Feld zu zeigen.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}: {value:.10g} m (die Regeln erlauben {least:g} bis {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... und {n} weitere</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>keine</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mausrad</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>am Mauszeiger vergrößern</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Zwei Finger</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>verschieben; gespreizt vergrößern</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Umschalt + Mausrad</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>seitwärts verschieben, wie ein Kipprad</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Leertaste + ziehen</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>verschieben</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mittlere Taste</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>X halten</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>alle Überlagerungen ausblenden</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Z halten</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Lupe: achtfache Bildpixel</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>, halten</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>die verglichene Kameraquelle ansehen</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>, tippen</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>mit der verglichenen Quelle beurteilen, mit dieser vergleichen</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Strg halten</translation>
  </message>
  <message>
   <source>click beside the line: no snapping</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>neben die Linie klicken: kein Einrasten</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Strg+Alt + Linie ziehen</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Kamera: sie folgt, die Stelle bleibt als Pflock</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Strg+Alt + Pflock klicken</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Kamera: den Pflock wegnehmen</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Pfeiltasten</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Fadenkreuz: die Tasten zeigen; gewählte Punkte werden statt dessen bewegt</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Leertaste am Fadenkreuz</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>was ein Klick dort tut (mit Strg: ohne Einrasten)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Rechte Taste</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Menü zu dem, was unter dem Mauszeiger ist</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Eingabe</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>den aktuellen Geist annehmen</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Umschalt+Eingabe</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>alle Geister annehmen</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Klick</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Zeichnen: einen Punkt hinzufügen</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Doppelklick</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Zeichnen: beenden</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Punkt ziehen</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: ihn verschieben</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Umschalt+Klick auf Punkt</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: mehrere wählen</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Auf freiem Grund ziehen</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: die Punkte darin wählen</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Linie ziehen</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: das Element verschieben, außer es ist festgehalten</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+Klick auf Linie</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: einen Punkt einfügen</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+Umschalt+Klick</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bearbeiten: den Punkt entfernen</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Streifen klicken oder ziehen</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>zu einem Bild gehen</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mausrad auf dem Streifen</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>vergrößern; mit Umschalt rollen</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Umschalt+ziehen auf dem Streifen</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>einen Abschnitt markieren (Doppelklick hebt ihn auf)</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>was im Bild gehalten wird</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Üblich</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Linkshändig</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Wie CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Wie labelme</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>erwartet: ein Objekt mit "actions" und "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" und "elements": erwartet sind Objekte</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: {value!r} ist keine Taste; erwartet ist eine wie {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: erwartet ist eine Liste von Tasten wie {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Bereiche</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} gibt es schon, und es steht etwas anderes darin.</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} löschen?</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Löschen</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Ersetzen</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Behalten</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} Bild ist nicht gespeichert, und das Speichern misslang eben noch einmal.</numerusform>
    <numerusform>{n} Bilder sind nicht gespeichert, und das Speichern misslang eben noch einmal.</numerusform>
   </translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Bleiben</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Schließen und verlieren</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Diese Meldung wegnehmen</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fremde neu laden</translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Zeigen, was in der Datei steht; Rückgängig bringt Ihre Fassung zurück</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mit eigener überschreiben</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Was Sie sehen, über die Datei schreiben</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Dieses Bild lässt sich nicht bearbeiten. {problem}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Anpassung und Geister</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Annotieren</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/settings.py, procc_annotator/gui/window/rail.py, the setting evidence]</extracomment>
   <translation>Bild</translation>
  </message>
  <message>
   <source>no camera</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>keine Kamera</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Jaccard-Index dieses Bildes bei tau</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Der Kamerasatz, der beurteilt wird (C wechselt)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Womit die Bewertung berechnet ist: {terms}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC –&lt;/b&gt; {why}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC –&lt;/b&gt; {why}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; of the fit</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; der Anpassung</translation>
  </message>
  <message>
   <source>&lt;b&gt;blind&lt;/b&gt;: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;blind&lt;/b&gt;: abgeben, um den JaC zu sehen</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Kamera unlesbar</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>hier keine Kamera</translation>
  </message>
  <message>
   <source>Three steps to a frame</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>In drei Schritten zum Bild</translation>
  </message>
  <message>
   <source>Click the two ends of a painted line, then Enter</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Die zwei Enden einer gemalten Linie klicken, dann Eingabe</translation>
  </message>
  <message>
   <source>{keys}: points along every line, on its paint</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}: Punkte entlang jeder Linie, auf ihrer Farbe</translation>
  </message>
  <message>
   <source>{keys}, then Enter: take what the camera expects</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}, dann Eingabe: nehmen, was die Kamera erwartet</translation>
  </message>
  <message>
   <source>Put the three steps away for ever (Help has the user guide)</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Die drei Schritte für immer weglegen (das Handbuch ist unter Hilfe)</translation>
  </message>
  <message>
   <source>Put the three steps away</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Die drei Schritte weglegen</translation>
  </message>
  <message>
   <source>{step}, done</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{step}, getan</translation>
  </message>
  <message>
   <source>Enter calls it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Eingabe führt aus · ↑ ↓ wählt · Esc schließt</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Nichts heißt „{text}“.</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Aktion, Element, Bild, Kameraquelle, Ordner, Zahl</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Alles finden</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Was passt</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>an</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>aus</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>diese Installation kam ohne ihr Handbuch</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>Über ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Kalibrierungen von Sportkameras mit dem ProCC-Protokoll annotieren und prüfen.</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>keine Kameras geladen (Strg+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>laden Sie einen zweiten Kamerasatz, um beide nebeneinander zu sehen (Strg+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>laden Sie einen zweiten Kamerasatz zum Vergleichen (Strg+L)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Ohne Geometrie</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Geist von {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Annehmen</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Genau ansehen</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action not_visible]</extracomment>
   <translation>Hier nicht sichtbar</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title} wird gezeichnet</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Hier teilen: der Rest wird</translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action ignore_finding]</extracomment>
   <translation>Diesen Befund übergehen</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Hier nicht sichtbar: zurücknehmen</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Klasse ändern in (tauscht mit einer annotierten)</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Punkt {number} von {title}</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Vereinen mit</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title}, unbestätigt</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>
    <numerusform>{n} Punkt</numerusform>
    <numerusform>{n} Punkte</numerusform>
   </translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Annotieren</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Beurteilen</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Prüfen</translation>
  </message>
  <message>
   <source>Desks</source>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Arbeitsplätze</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Feldkarte</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Elemente</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/window/docks.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Kameras</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Bewertung</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Anpassung</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Prüfung</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/docks.py, the action plots]</extracomment>
   <translation>Diagramme</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Durchsicht</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Übereinstimmung</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Wörter auf dieser Seite suchen</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Das Handbuch ist auf Englisch.</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/guide.py, the action guide]</extracomment>
   <translation>Handbuch</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Überschriften</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_columns.py]</extracomment>
   <translation>{one} oder {other}</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Im Bild</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py, procc_annotator/gui/window/keymap_dialog.py, the action keys]</extracomment>
   <translation>Tasten</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Suche: ein Wort oder eine Taste. Ein Klick tut, was die Zeile sagt.</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Tasten durchsuchen</translation>
  </message>
  <message>
   <source>Actions and their keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Aktionen und ihre Tasten</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Keine Taste, keine Aktion und kein Element hat „{text}“.</translation>
  </message>
  <message>
   <source>Choose an element</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Element wählen</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Eigene Tasten</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Tasten (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}: {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Suche: ein Wort oder eine Taste</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Eine Zeile wählen, dann ihre Tasten drücken</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Tasten ändern</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Suche</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Alle Tasten auf einmal</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Nur diese</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Keine Tasten</translation>
  </message>
  <message>
   <source>Usual keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Übliche Tasten</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Exportieren…</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Importieren…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ Tasten, die zwei Aktionen rufen, rufen keine: geben Sie einer davon andere Tasten.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Tasten exportieren</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Tasten importieren</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ auch: {what}</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Neue Tasten: hier drücken</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>{file}: {error}; die Tasten bleiben, wie sie sind</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Aktion oder Element</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}: {step}</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Bereich</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Öffnen</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Bild {number} von {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Zu diesem Bild gehen</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Beurteilen: {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Mit dieser Quelle beurteilen</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Laufende Anpassung: Modell {model}</translation>
  </message>
  <message>
   <source>Fit this model to the clicks; auto takes the simplest that they support</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Dieses Modell an die Klicks anpassen; auto nimmt das einfachste, das sie hergeben</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Bereich {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Diesen Bereich öffnen und nach vorn holen</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Schwelle {px:g} px</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Elemente mit diesem tau beurteilen</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Werkzeugleiste</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Bild
Helligkeit, Kontrast, Gamma, Linien verstärken: nur was Sie sehen, ändert sich</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>gespeichert {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>
    <numerusform>NICHT GESPEICHERT: {n} Bild</numerusform>
    <numerusform>NICHT GESPEICHERT: {n} Bilder</numerusform>
   </translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>speichert...</translation>
  </message>
  <message>
   <source>no changes</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>keine Änderungen</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Einstellungen durchsuchen</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>{setting}: zurück auf {value}</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>All to their defaults</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Alle auf die Vorgaben</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py, the action keymap]</extracomment>
   <translation>Tasten ändern…</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Keine Einstellung hat „{text}“.</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>kein eigener</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Boden ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Mauszeiger in Bildpixeln; die Mitte des Pixels oben links ist 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Mauszeiger auf dem Boden des Feldes, in Metern von seiner Mitte</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Wie weit auseinander die aktive und die verglichene Kamera den Mauszeiger sehen:
am Boden, und in Pixeln der Auswertungsgröße</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Wie sicher die angepasste Kamera den Bodenpunkt am Mauszeiger kennt: Standard-
abweichung in der schlechtesten Richtung, was immer der Mauszeiger selbst danebenliegt</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>bewertet {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Kamera &gt; Bewertung des Satzes anhalten beendet es</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>vergleicht {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Geister {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Esc beendet es</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Schwelle tau: ein Element besteht, wenn alle seine Punkte näher liegen (+ und -)</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Schwelle tau</translation>
  </message>
  <message>
   <source>Top bar</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Obere Leiste</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Status dieses Bildes (Bereich Durchsicht)</translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Feld: {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Klicken, um ein anderes zu wählen</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Einen Ordner mit Bildern hierher ziehen</translation>
  </message>
  <message>
   <source>Annotations are read from and saved to SoccerNet JSON beside the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Annotationen werden als SoccerNet-JSON neben den Bildern gelesen und gespeichert. Ein Ordner mit Kameras, später hierher gezogen, wird an Ihren Klicks gemessen.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Zuletzt geöffnet</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Ordner öffnen…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Bild öffnen…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Video öffnen…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Beispiel ausprobieren</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Weitermachen mit</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Noch nichts geöffnet</translation>
  </message>
  <message>
   <source>unexpected error ({what}); the terminal says more</source>
   <extracomment>[procc_annotator/gui/worker.py]</extracomment>
   <translation>unerwarteter Fehler ({what}); im Terminal steht mehr</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/writing.py]</extracomment>
   <translation>öffnen Sie zuerst einen Ordner mit Bildern</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>was anderswo gespeichert wurde</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>überschrieben</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>wie vorgefunden</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>zurückgenommen</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>gespeichert</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Alle Bilder eines Ordners annotieren</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Ein einzelnes Bild annotieren</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Bilder eines Videos annotieren, ohne sie vorher herauszuschreiben</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Beispiel öffnen</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Eine eigene Kopie der mitgelieferten Bilder öffnen</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Zweiten Annotator öffnen…</translation>
  </message>
  <message>
   <source>Draw and compare what somebody else clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Zeichnen und vergleichen, was jemand anders in denselben Bildern geklickt hat</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Zweiten Annotator schließen</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Wieder nur die Annotationen dieses Datensatzes zeigen</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[the field american_football, the menus]</extracomment>
   <translation>Feld</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Aus einer Datei…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Eine eigene Beschreibung: jede Sportart, siehe Handbuch</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Zum passenden Feld wechseln</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Das Feld zeigen, das die in diesem Bild annotierten Klassen kennt</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Datei neu lesen</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Geschieht von selbst, wenn die Felddatei dieses Datensatzes geschrieben wird</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Jetzt speichern</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Jede fertige Änderung wird sofort gespeichert; dies versucht noch einmal, was misslang</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Annotationen importieren…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Annotationen eines anderen Programms oder Datensatzes Bild für Bild übernehmen</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exportieren als…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Die Annotationen für ein anderes Programm schreiben: CVAT, labelme, COCO, SoccerNet, Masken</translation>
  </message>
  <message>
   <source>Export SoccerNet JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>SoccerNet-JSON exportieren…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of SoccerNet JSON</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Die Annotationen aller Bilder als Ordner oder Zip mit SoccerNet-JSON schreiben</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>JaC des Satzes exportieren…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Den JaC jedes Bildes als CSV oder JSON schreiben</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Herkunft exportieren…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Als begleitendes JSON schreiben, wie und durch wen jeder Punkt entstand</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Bild mit Überlagerung speichern…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Das Bild mit Annotation und Projektion samt Legende als PNG, JPEG oder SVG schreiben</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Übersicht exportieren…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Status, Anzahlen und Zeit jedes Bildes als CSV schreiben</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Urteile exportieren…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Als CSV schreiben, woran es in welchem Bild liegt, mit JaC und größtem Fehler</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Befunde exportieren…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Als CSV schreiben, was die Klassenprüfung in den bisher geprüften Bildern fand</translation>
  </message>
  <message>
   <source>Your name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Ihr Name…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>Der Name, den Ihre Punkte, Kommentare und Fassungen tragen</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Beenden</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Das Fenster schließen; alles ist gespeichert</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Rückgängig</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Den letzten Schritt in diesem Bild zurücknehmen</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Wiederholen</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Den Schritt noch einmal tun</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Punkt oder Element löschen</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Den gewählten Punkt entfernen; ohne einen das gewählte Element</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Alle Punkte wählen</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Alle Punkte des gewählten Elements wählen, oder alle des Bildes</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Abbrechen</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Die eben geklickten Punkte verwerfen, dann die Auswahl aufheben</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Einstellungen…</translation>
  </message>
  <message>
   <source>Theme, size of texts, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Farbschema, Textgröße, und wie das Fenster zeichnet, anpasst und urteilt</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Mit den Pfeiltasten</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Die gewählten Punkte 1 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px nach rechts</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px nach oben</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px nach unten</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Die gewählten Punkte 0.1 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px nach rechts</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px nach oben</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px nach unten</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Die gewählten Punkte 10 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px nach rechts</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px nach oben</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px nach unten</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px nach links</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Die gewählten Punkte 100 px verschieben; ist keiner gewählt, das Fadenkreuz</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px nach rechts</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px nach oben</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px nach unten</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Nächstes Bild</translation>
  </message>
  <message>
   <source>Show the next picture</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Das nächste Bild zeigen</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Voriges Bild</translation>
  </message>
  <message>
   <source>Show the previous picture</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Das vorige Bild zeigen</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Nächstes unfertiges</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Zum nächsten Bild, das weder fertig noch freigegeben ist</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Voriges unfertiges</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Zurück zum vorigen Bild, das weder fertig noch freigegeben ist</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Nächstes zurückgewiesenes</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Zum nächsten Bild, das ein Prüfer zurückgegeben hat</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Nächstschlechtester JaC</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Das Bild mit dem niedrigsten JaC; noch einmal: das nächstbessere</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Nächstgrößter Fehler</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Das Bild mit dem größten Fehler eines Punktes; noch einmal: das mit dem nächstkleineren</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Nächstes nach Abweichung</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Das Bild, in dem die aktive Quelle und die verglichene am Boden am weitesten auseinanderliegen; noch einmal: das nächste</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Klassenprüfung</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Nächster Befund</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Zum nächsten, was die Klassenprüfung fand, Bild für Bild</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Voriger Befund</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Zurück zum vorigen Befund</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Erste Abhilfe ausführen</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Den aktuellen Befund beheben: umbenennen, tauschen, den falschen Punkt entfernen, oder ansehen</translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[the action ignore_finding]</extracomment>
   <translation>Ihn nicht mehr zeigen, bis sich die Punkte seiner Elemente ändern</translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>Ganzen Satz prüfen</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>In jedem annotierten Bild nach falschen Klassen suchen</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Nächstes ohne Annotation</translation>
  </message>
  <message>
   <source>Go on to the next frame where nothing is annotated</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Zum nächsten Bild, in dem nichts annotiert ist</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Voriges ohne Annotation</translation>
  </message>
  <message>
   <source>Go back to the frame before where nothing is annotated</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Zurück zum vorigen Bild, in dem nichts annotiert ist</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Erstes Bild</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Das erste Bild zeigen</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Letztes Bild</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Das letzte Bild zeigen</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Der Einstellung folgen</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Die Kameras aller Bilder dieser Einstellung finden, von diesem aus in beide Richtungen; noch einmal hält an</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Abschnitt annehmen</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; doubtful frames and annotated ones are left out</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Die Bilder der Einstellung, oder des auf dem Streifen markierten Abschnitts, entlang ihrer Spur annotieren; zweifelhafte und annotierte Bilder bleiben aus</translation>
  </message>
  <message>
   <source>Take back the accepted stretch</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Angenommenen Abschnitt zurücknehmen</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Zuletzt angenommene und seither nicht bearbeitete Bilder werden wieder, wie sie waren</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Zehn Bilder weiter</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Zehn Bilder weitergehen</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Zehn Bilder zurück</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Zehn Bilder zurückgehen</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Nächstes annotiertes Bild</translation>
  </message>
  <message>
   <source>Go on to the next frame of the shot that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Zum nächsten annotierten Bild der Einstellung</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Voriges annotiertes Bild</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Zurück zum vorigen annotierten Bild</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Nächstes zweifelhaftes Bild</translation>
  </message>
  <message>
   <source>Go on to the next frame whose track should be looked at</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Zum nächsten Bild, dessen Spur angesehen werden sollte</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Voriges zweifelhaftes Bild</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Zurück zum vorigen zweifelhaften Bild</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Abspielen oder anhalten</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Die Bilder nacheinander zeigen; noch einmal, oder jede Änderung, hält an</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Bild suchen…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Einen Teil des Bildnamens tippen</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Blindmodus</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Die Projektion verbergen, bis das Bild abgegeben ist, damit die Kamera die Klicks nicht beeinflusst</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Datensatz auf Blindmodus festlegen</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Blindmodus für alle, die diesen Datensatz annotieren; das Aufheben fragt nach und wird vermerkt</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Fertig</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Dieses Bild ist fertig; im Blindmodus zeigt das die Projektion</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Freigeben</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Ein Prüfer befindet dieses Bild für richtig</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Zurückweisen</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Ein Prüfer gibt dieses Bild zurück; der Grund gehört in einen Kommentar</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Wieder in Arbeit</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Dieses Bild ist doch nicht fertig</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Kommentar…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Etwas zu diesem Bild schreiben</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Frühere Fassungen…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Alle gespeicherten Fassungen dieses Bildes ansehen und eine zurückholen</translation>
  </message>
  <message>
   <source>Overview of the set…</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Übersicht des Satzes…</translation>
  </message>
  <message>
   <source>Counts per status and class, progress, time per frame</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Anzahlen je Status und Klasse, Fortschritt, Zeit je Bild</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Ansichten gruppieren…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Über die Namen sagen, welche Bilder denselben Augenblick aus verschiedenen Kameras zeigen</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Dieses Videobild behalten</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture beside its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Das Bild des Videos als Bilddatei neben seine Annotation schreiben</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Vom vorigen Bild kopieren</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Elemente des zuvor annotierten Bildes übernehmen, verschoben wie die Kamera; sie warten auf Bestätigung</translation>
  </message>
  <message>
   <source>Confirm all copied elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Alle kopierten Elemente bestätigen</translation>
  </message>
  <message>
   <source>Copied elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Kopierte Elemente zählen und werden ab jetzt gespeichert</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Unbestätigte Elemente verwerfen</translation>
  </message>
  <message>
   <source>Throw away what was copied and nobody touched</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Wegwerfen, was kopiert und nicht angefasst wurde</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Alle Elemente begradigen</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Jedes Element des Bildes entlang seiner gemalten Linie neu abtasten</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Zeichnen</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Klicks fügen dem gewählten Element Punkte hinzu</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Punkte ziehen, einfügen und entfernen</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Zwischen Zeichnen und Bearbeiten wechseln</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Vom Zeichnen zum Bearbeiten und zurück</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Nächstes Element</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Das nächste Element des Feldes wählen</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Voriges Element</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Das vorige Element wählen</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Element suchen…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Einen Teil des Elementnamens tippen</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Element beenden</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Die eben geklickten Punkte zu einem Element machen (oder den letzten doppelt klicken)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Beenden und bleiben</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Das Element beenden, ohne zum nächsten zu gehen</translation>
  </message>
  <message>
   <source>Take back last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Letzten Punkt zurücknehmen</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Den zuletzt geklickten Punkt entfernen</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Element löschen</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Das gewählte Element mit allen Punkten entfernen</translation>
  </message>
  <message>
   <source>Confirm copied element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Kopiertes Element bestätigen</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Das gewählte Element zählt und wird ab jetzt gespeichert (beim Bearbeiten: Eingabe)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Begradigen</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Das Element entlang seiner gemalten Linie neu abtasten: zwei Klicks ergeben ein gerades, fünf ein gebogenes Element</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Lücken schließen</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Die Enden des Elements bis zur Ecke oder zum Bildrand verlängern, die sie verfehlen</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Umkehren</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Die Reihenfolge der Punkte des Elements umdrehen</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>In die symmetrische Klasse kopieren</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Eine Kopie unter der Klasse des gedrehten Feldes anlegen, um sie an ihren Platz zu ziehen</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>An Linien einrasten</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click beside it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Klicks nahe einer gemalten Linie gehen auf deren Mitte (Strg halten, um daneben zu klicken)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Zum nächsten Element weitergehen</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Nach dem Beenden eines Elements das wahrscheinlich nächste wählen</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Zwei Klicks beenden ein gerades Element</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Der zweite Klick auf einem geraden Element beendet es</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Erst zeichnen, dann benennen</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Ohne gewähltes Element beginnt ein Klick eine Linie; ist sie fertig, werden am Stift die wahrscheinlichsten Elemente angeboten</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Elemente festhalten</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Nur Punkte lassen sich ziehen, keine ganzen Elemente</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Geister</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Nächster Geist</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Das nächste Element ansehen, das die angepasste Kamera erwartet</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Voriger Geist</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Das vorige ansehen</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Geist annehmen</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Den Geist zum Element machen: Punkte auf seiner gemalten Linie, keine, wo sie verdeckt ist (Eingabe)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Alle Geister annehmen</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Alle Geister annehmen, deren gemalte Linien gut genug zu sehen sind (Umschalt+Eingabe, solange nichts gezeichnet wird)</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Sichtbarer Teil, um alle anzunehmen…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Wie viel der gemalten Linie eines Geistes zu sehen sein muss, damit er mit allen angenommen wird</translation>
  </message>
  <message>
   <source>The ghost, or the chosen element, cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>Der Geist oder das gewählte Element ist in diesem Bild nicht zu sehen; noch einmal nimmt es zurück</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>„Hier nicht sichtbar“ zurücknehmen</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Das Element, das zuletzt als nicht sichtbar galt, ist vielleicht doch zu sehen</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Geister zeigen</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Blasse Kurven zeichnen, wo die angepasste Kamera noch nicht annotierte Elemente erwartet</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Kamera im Bild suchen</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Wo noch nichts annotiert ist, die Kamera ohne Klick finden und ihre Elemente als Geister zeigen; gespeichert wird nichts, bevor es angenommen ist</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Sagen, was als Nächstes zu annotieren ist</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Auf der Feldkarte das Element markieren, das die angepasste Kamera am sichersten machte</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>In Fenster einpassen</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Das ganze Bild zeigen</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Originalgröße</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Ein Bildpixel ist ein Bildschirmpixel</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Vergrößern</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Vergrößern (das Mausrad tut es am Mauszeiger)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Verkleinern</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Verkleinern (das Mausrad tut es am Mauszeiger)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Verschieben</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Die linke Taste bewegt das Bild (oder Leertaste halten, oder mittlere Taste); Esc beendet es</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Ausschnitt beibehalten</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Beim Bildwechsel an derselben Stelle bleiben</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Überlagerungen ausblenden</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Das bloße Bild zeigen (oder X halten)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Färben nach</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Kriterium</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Farben sagen, wie die Kamera beurteilt wird</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Klasse</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Jedes Element in seiner eigenen Farbe</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Herkunft</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Punkte danach, wie sie entstanden: geklickt, eingerastet, begradigt, kopiert, verschoben</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Annotator</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Punkte danach, wer sie gesetzt hat</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Linienbreite</translation>
  </message>
  <message>
   <source>Draw how wide the paint of the field's lines must appear, beside the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Neben der Projektion zeigen, wie breit die Farbe der Feldlinien erscheinen muss</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Belege im Bild</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Neben jedem Abschnitt ein Streifen: durchgezogen, wo das Bild darunter Farbe zeigt, gestrichelt, wo Farbe daneben verläuft, auf dieser Seite, gepunktet, wo keine ist</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Lupe</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Die Lupe am Mauszeiger behalten (oder Z halten; sie kommt auch beim Ziehen eines Punktes)</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Feldkarte zur Kamera drehen</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint; the half that is out of sight leaves its room to the other one</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Auf der Feldkarte liegt die Seite unten, auf der die Kamera steht, und was sie nicht sieht, ist blass; die Hälfte außer Sicht überlässt ihren Platz der anderen</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bilderstreifen</translation>
  </message>
  <message>
   <source>Below the picture: of a video, or of frames that follow one another, how their cameras do and where they are annotated; of other frames small pictures with their states</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Unter dem Bild: bei einem Video oder aufeinanderfolgenden Bildern, wie gut ihre Kameras sind und wo annotiert ist; bei anderen kleine Bilder mit ihrem Zustand</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set as plots, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Fehler und JaC des Bildes oder des Satzes als Diagramme, für alle gezeigten Quellen</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Bereiche zum Annotieren</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Elemente, Befunde der Prüfung, Landmarken</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Bereiche zum Beurteilen</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Bewertungen, Kameraquellen, Anpassung, Diagramme</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Bereiche zum Prüfen</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Status, Kommentare und Zeit, ein zweiter Annotator</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Alle Bereiche ausblenden</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Dem Bild allen Platz geben</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Tastatur zu den Bereichen</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Im Bild geht Tab durch die Geister; dies führt die Tastatur weiter zu den Bereichen</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Tastatur zum nächsten Teil</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Bild, Bereiche, Leisten: die Tastatur geht reihum</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Tastatur zum vorigen Teil</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Reihum in der anderen Richtung</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Anordnung zurücksetzen</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Die Bereiche wieder an ihren ersten Platz legen</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Kameras laden…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Einen Ordner mit Kameras oder Homographien an den Annotationen messen</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Kameradatei laden…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Eine einzelne Kameradatei oder ein Zip davon beurteilen</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Nächste Kameraquelle</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Mit der nächsten geladenen Quelle beurteilen</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Vorige Kameraquelle</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Mit der vorigen beurteilen</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Mit der verglichenen Quelle tauschen</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Mit der verglichenen Quelle beurteilen und mit dieser vergleichen (oder Komma tippen; halten, um nur zu schauen)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Andere Quellen zeichnen</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes beside the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Die im Bereich Kameras angehakten Quellen als Drahtgitter neben der aktiven zeichnen</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Geteilte Ansicht</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Links einer Trennlinie die aktive Quelle zeichnen, rechts die verglichene</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>Abweichung</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>Wie viele Meter die aktive und die verglichene Quelle jedes Pixel am Boden auseinander sehen</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Karte der Unsicherheit</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Wo auf dem Feld die angepasste Kamera auf 0,1, 0,5 und 1 m genau ist</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Laufende Anpassung</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Nach jeder Änderung eine Kamera an die Klicks des Bildes anpassen</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Anpassung als Kamera des Bildes speichern</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Die an die Klicks angepasste Kamera in den Ordner cameras/fitted des Datensatzes schreiben</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Feldmaße…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Länge und Breite des Feldes in diesem Stadion, eingegeben oder aus allen Bildern ermittelt; und wo auf seinen Linien die Klicks liegen</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Schwelle 0.5 px höher</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Größere Abstände zulassen</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Schwelle 0.5 px tiefer</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Nur kleinere Abstände zulassen</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[the menus, the setting protocol]</extracomment>
   <translation>Protokoll</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>Die offizielle SoccerNet-Auswertung, mit ihren Eigenheiten</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>Die Definition der Veröffentlichung, ohne die Artefakte des offiziellen Codes</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Elemente über dem Boden</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Als verfehlt zählen</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Tore, Körbe und Netze, die eine Homographie nicht projizieren kann, zählen gegen sie</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Auslassen</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Tore, Körbe und Netze, die eine Homographie nicht projizieren kann, werden nicht gezählt</translation>
  </message>
  <message>
   <source>Camera fault</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Fehler der Kamera</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Die aktive Kamera ist in diesem Bild falsch; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>Annotation fault</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Fehler der Annotation</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Die Klicks sind in diesem Bild falsch; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>Fine</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>In Ordnung</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Kamera und Klicks sind in diesem Bild richtig; noch einmal nimmt das Urteil zurück</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Notiz zum Urteil…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>In wenigen Worten sagen, was falsch ist; es wird mit dem Urteil exportiert</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Bewertung des Satzes anhalten</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Den JaC noch nicht geöffneter Bilder und den Vergleich der Quellen nicht weiter berechnen</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Alles finden…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Die Befehlspalette: jede Aktion, jedes Element, Bild, jede Kameraquelle und jeder letzte Ordner nach ein paar Buchstaben des Namens</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Alle Aktionen und ihre Tasten auf einem Blatt zeigen</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Aktionen und Elementen andere Tasten geben, oder die eines anderen Programms übernehmen</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>Das mitgelieferte Handbuch; es braucht kein Netz</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Version</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Aussehen</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Farbschema</translation>
  </message>
  <message>
   <source>Light, dark, or as the system has it</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Hell, dunkel, oder wie das System es hat</translation>
  </message>
  <message>
   <source>As the system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Wie das System</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Hell</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Dunkel</translation>
  </message>
  <message>
   <source>Size of texts</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Textgröße</translation>
  </message>
  <message>
   <source>How large texts are, of what the system says; from the next start on</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Wie groß Texte sind, gemessen an der Vorgabe des Systems; ab dem nächsten Start</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Sprache</translation>
  </message>
  <message>
   <source>The language of the window; from the next start on. Files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Die Sprache des Fensters; ab dem nächsten Start. Dateien bleiben, wie sie sind</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Was die Farben über dem Bild sagen</translation>
  </message>
  <message>
   <source>Your name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Ihr Name</translation>
  </message>
  <message>
   <source>Whose name points, comments and versions bear; empty: that of the system's user</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Wessen Namen Punkte, Kommentare und Fassungen tragen; leer: den des Systembenutzers</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Beurteilen</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Schwelle</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Wie weit ein annotierter Punkt von seinem Element entfernt sein darf, in px der Auswertungsgröße</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Wie Kameras beurteilt werden: wie in der offiziellen Auswertung samt Eigenheiten, oder nach der Definition der Veröffentlichung</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>soccernet (offiziell)</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (Veröffentlichung)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Wie Elemente zählen, die eine Homographie nicht projizieren kann: Tore, Körbe, Netze</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modell der laufenden Anpassung</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Die Kamera, die an die Klicks angepasst wird; auto: die einfachste, die sie hergeben</translation>
  </message>
  <message>
   <source>auto</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>auto</translation>
  </message>
  <message>
   <source>H</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>H</translation>
  </message>
  <message>
   <source>P</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>P</translation>
  </message>
  <message>
   <source>R</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R</translation>
  </message>
  <message>
   <source>R+</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R+</translation>
  </message>
  <message>
   <source>R2</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>R2</translation>
  </message>
  <message>
   <source>F</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>F</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Anpassung beurteilen</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Ob die Anpassung beurteilt wird, wo es nichts anderes gibt</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Sichtbarer Teil, um alle anzunehmen</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Wie viel der Linie eines Geistes zu sehen sein muss, um ihn mit allen anderen anzunehmen</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>American Football (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Nahe Hash-Marken</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ferne Hash-Marken</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Linke Endlinie</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linke Torlinie</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 5-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 10-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 15-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 20-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 25-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 30-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 35-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 40-Yard-Linie</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke 45-Yard-Linie</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>50-Yard-Linie</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Rechte Endlinie</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechte Torlinie</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 5-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 10-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 15-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 20-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 25-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 30-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 35-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 40-Yard-Linie</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte 45-Yard-Linie</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linke Querlatte</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linkes Tor, linke Stange</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linkes Tor, rechte Stange</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechte Querlatte</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechtes Tor, linke Stange</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechtes Tor, rechte Stange</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke Try-Marke</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte Try-Marke</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Länge mit beiden Endzonen</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Tiefe einer Endzone</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard-Linie zur Seitenlinie</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash-Marken zur Seitenlinie</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Try-Marke zur Torlinie</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Länge der Try-Marke</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Torbreite</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Höhe der Querlatte</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Stangen über der Querlatte</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Linienbreite</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Breite der Torlinie</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Breite des Randes</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Linke Hälfte</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Rechte Hälfte</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Leichtathletik (400-m-Bahn)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordkante</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnlinie 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahn 8, äußerer Rand</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahn 9, äußerer Rand</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ziellinie</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 110 m Hürden</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 3000 m und 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Linie zum Einbiegen</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 200 m, Bahn 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 400 m, Bahn 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Start 800 m, Bahn 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, innere Linie</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn, Linie 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Länge über acht Bahnen</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Breite über acht Bahnen</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnbreite</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bahnen</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ziel und Starts</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Starts über 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Sprintbahn</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Basketball (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Endlinie</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Endlinie</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Mittellinie</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Mittelkreis</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone, ferne Seite</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Linke Freiwurflinie</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone, nahe Seite</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Linker Freiwurfhalbkreis</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone, ferne Seite</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Rechte Freiwurflinie</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone, nahe Seite</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rechter Freiwurfhalbkreis</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Dreipunktebogen</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie, ferne Gerade</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie, nahe Gerade</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Dreipunktebogen</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie, ferne Gerade</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie, nahe Gerade</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linkes Spielbrett</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Ring</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Linker No-Charge-Halbkreis</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechtes Spielbrett</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Ring</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rechter No-Charge-Halbkreis</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechteck des linken Spielbretts</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Mitte des linken Rings</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechteck des rechten Spielbretts</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Mitte des rechten Rings</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Mittellinie über die Seitenlinien hinaus</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Radius des Kreises</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Länge der Zone</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite der Zone</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radius der Dreipunktelinie</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Dreipunktelinie zur Seitenlinie</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Radius des No-Charge-Halbkreises</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Spielbrett zur Endlinie</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Unterkante des Spielbretts</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Breite des Rechtecks</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Rechtecks</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Höhe des Rings</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radius des Rings</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ring zum Spielbrett</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Spielfeld</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Zone</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Zone</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linke Dreipunktelinie</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechte Dreipunktelinie</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Linker Korb</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rechter Korb</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Basketball (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linker Freiwurfkreis</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechter Freiwurfkreis</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linker Bogen der Schutzzone</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechter Bogen der Schutzzone</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Innerer Mittelkreis</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linke ferne Hash-Marke</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechte ferne Hash-Marke</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Linke nahe Hash-Marke</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rechte nahe Hash-Marke</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radius des inneren Kreises</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radius der Schutzzone</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash-Marke zur Endlinie</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Länge der Hash-Marke</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Futsal</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Mittellinie</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Linke Strafraumlinie</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rechte Strafraumlinie</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor, ferner Pfosten</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Linkes Tor, naher Pfosten</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor, ferner Pfosten</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Rechtes Tor, naher Pfosten</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Anstoßpunkt</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Linker zweiter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rechter zweiter Strafstoßpunkt</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker ferner Viertelkreis</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker naher Viertelkreis</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter ferner Viertelkreis</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter naher Viertelkreis</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, links außen</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, links innen</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, rechts innen</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ferne Wechselzone, rechts außen</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, links außen</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, links innen</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, rechts innen</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Nahe Wechselzone, rechts außen</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Breite der Torpfosten</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radius des Strafraums</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Strafstoßpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zweiter Strafstoßpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radius des Mittelkreises</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Radius der Viertelkreise</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Torhöhe</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Spielfeld</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Linker Strafraum</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rechter Strafraum</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punkte</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ecken</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Wechselzonen</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Handball</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Nahe Seitenlinie</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ferne Seitenlinie</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Anwurfzone</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke Torraumlinie</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke 7-Meter-Linie</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Linke 4-Meter-Linie</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte Torraumlinie</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte 7-Meter-Linie</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rechte 4-Meter-Linie</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ferne Wechsellinie, links</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ferne Wechsellinie, rechts</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Nahe Wechsellinie, links</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Nahe Wechsellinie, rechts</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radius des Torraums</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radius der Freiwurflinie</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Linker Torraum</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Rechter Torraum</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Wechsellinien</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Eishockey (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe Seitenbande</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne Seitenbande</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linke Endbande</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechte Endbande</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe linke Ecke</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne linke Ecke</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Nahe rechte Ecke</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferne rechte Ecke</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linke blaue Linie</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechte blaue Linie</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Kreis</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Kreis</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Kreis</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Kreis</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linker Torraum</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Linkes Tor, linker Pfosten</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Linkes Tor, rechter Pfosten</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechter Torraum</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Rechtes Tor, linker Pfosten</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Rechtes Tor, rechter Pfosten</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linkes Trapez, nah</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linkes Trapez, fern</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechtes Trapez, nah</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rechtes Trapez, fern</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Schiedsrichterkreis, nah</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Schiedsrichterkreis, fern</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Mittelpunkt</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Endpunkt</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Endpunkt</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Endpunkt</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Endpunkt</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher linker Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner linker Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Naher rechter Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ferner rechter Punkt der neutralen Zone</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen Bande</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen Bande</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der linken Bande</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der rechten Bande</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen linken Ecke</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen linken Ecke</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der nahen rechten Ecke</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der fernen rechten Ecke</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius der Ecken</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Höhe der Bande</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Torlinie zur Endbande</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Blaue Linie zur Endbande</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius der Bullykreise</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Endpunkt zur Torlinie</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punkt der neutralen Zone zur blauen Linie</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punkt zur Längsachse</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius des Torraums</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Breite des Torraums</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radius des Schiedsrichterkreises</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapez an der Torlinie</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapez an der Endbande</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Breite der blauen und der Mittellinie</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Linien</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bullykreise</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bullypunkte</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Oberkante der Bande</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Eishockey (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Blaue Linie zur Torlinie</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Fußball</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, nah</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, vorn</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Strafraum, fern</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, nah</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, vorn</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Strafraum, fern</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Teilkreis</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Teilkreis</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, nah</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, vorn</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linker Torraum, fern</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, nah</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, vorn</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechter Torraum, fern</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linke ferne Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linke nahe Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechte ferne Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Rechte nahe Eckfahne (Fuß)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tiefe des Strafraums</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Breite des Strafraums</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tiefe des Torraums</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Breite des Torraums</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Tor, unbestimmt</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Linie, unbestimmt</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tennis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linke Grundlinie</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechte Grundlinie</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Doppel-Seitenlinie</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Doppel-Seitenlinie</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Einzel-Seitenlinie</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Einzel-Seitenlinie</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linke Aufschlaglinie</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechte Aufschlaglinie</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlagmittellinie</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Oberkante des Netzes</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferner Netzpfosten</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Naher Netzpfosten</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhalter in der Mitte</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ferne Einzelstütze</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Nahe Einzelstütze</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Linkes Mittelzeichen</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Rechtes Mittelzeichen</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite des Einzelfelds</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlaglinie zum Netz</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite der Grundlinie</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Breite der Mittellinie</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Länge des Mittelzeichens</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe am Netzhalter</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe an den Pfosten</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzhöhe an den Einzelstützen</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Netzpfosten zur Seitenlinie</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Aufschlagfelder</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Netz</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Volleyball</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke Angriffslinie</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte Angriffslinie</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Oberes Netzband</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Unteres Netzband</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ferne Antenne</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Nahe Antenne</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ferner Pfosten</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Naher Pfosten</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke ferne Verlängerung</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linke nahe Verlängerung</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte ferne Verlängerung</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechte nahe Verlängerung</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linkes fernes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Linkes nahes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechtes fernes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Rechtes nahes Aufschlagzeichen</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Angriffslinie zur Mittellinie</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Netzhöhe</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Höhe des Netztuchs</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Netzlänge</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne über dem Netz</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Pfosten zur Seitenlinie</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Höhe der Pfosten</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Verlängerung der Angriffslinie</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Aufschlagzeichen zur Endlinie</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Länge des Aufschlagzeichens</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Zeichen außerhalb des Feldes</translation>
  </message>
 </context>
</TS>
