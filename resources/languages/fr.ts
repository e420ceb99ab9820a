<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Fichier</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Édition</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/context_menu.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Image</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Élément</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Affichage</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/palette_entries.py, the menus]</extracomment>
   <translation>Caméra</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Aide</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} élément, symétries : {turns}</numerusform>
    <numerusform>{n} éléments, symétries : {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Il n’y a pas encore de terrain à montrer.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension} : {value:.10g} m (les règles permettent de {least:g} à {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... et {n} de plus</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>aucune</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Molette</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>zoom au curseur</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Deux doigts</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>déplacer ; pincés, zoom</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Maj + molette</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>déplacer de côté, comme une molette inclinée</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Espace + glisser</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>déplacer</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bouton du milieu</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Tenir X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>cacher toutes les superpositions</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Tenir Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>loupe : huit fois les pixels de l’image</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Tenir ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>regarder la source de caméras comparée</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Taper ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>juger avec la source comparée, comparer avec celle-ci</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Tenir Ctrl</translation>
  </message>
  <message>
   <source>click beside the line: no snapping</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>cliquer à côté de la ligne : sans aimant</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + glisser une ligne</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>caméra : elle suit, l’endroit reste comme piquet</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + cliquer un piquet</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>caméra : retirer le piquet</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Flèches</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>réticule : les touches pointent ; les points choisis sont plutôt déplacés</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Espace au réticule</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>ce qu’un clic y fait (avec Ctrl : sans aimant)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Bouton droit</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>menu de ce qui est sous le curseur</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Entrée</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>accepter le fantôme actuel</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Maj+Entrée</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>accepter tous les fantômes</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Clic</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>dessin : ajouter un point</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Double-clic</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>dessin : terminer</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Glisser un point</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : le déplacer</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Maj+clic sur un point</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : en choisir plusieurs</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Glisser sur un endroit vide</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : choisir les points à l’intérieur</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Glisser une ligne</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : déplacer l’élément, sauf si les éléments sont épinglés</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+clic sur une ligne</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : insérer un point</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+Maj+clic</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>édition : retirer le point</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Cliquer ou glisser sur la bande</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>aller à une image</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Molette sur la bande</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>zoom ; avec Maj, défiler</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Maj+glisser sur la bande</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>marquer un passage (un double-clic le lâche)</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ce qui se tient enfoncé dans l’image</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Habituelles</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Gaucher</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Comme CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Comme labelme</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>attendu : un objet avec "actions" et "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" et "elements" : des objets sont attendus</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place} : {value!r} n’est pas une touche ; il en faut une comme {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place} : une liste de touches est attendue, comme {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Panneaux</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} existe déjà, et dit autre chose.</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Supprimer {what} ?</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Supprimer</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Le remplacer</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Le garder</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} image n’est pas enregistrée, et l’enregistrement vient d’échouer encore.</numerusform>
    <numerusform>{n} images ne sont pas enregistrées, et l’enregistrement vient d’échouer encore.</numerusform>
   </translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Rester</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fermer et les perdre</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Fermer ce message</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Recharger les leurs</translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Montrer ce qui est dans le fichier ; annuler ramène votre version</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Écraser avec les miennes</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Écrire ce que vous voyez par-dessus le fichier</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Cette image n’est pas modifiable. {problem}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Ajustement et fantômes</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Annotation</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/settings.py, procc_annotator/gui/window/rail.py, the setting evidence]</extracomment>
   <translation>Image</translation>
  </message>
  <message>
   <source>no camera</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>pas de caméra</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Indice de Jaccard de cette image à tau</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Le jeu de caméras qui est jugé (C change)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Avec quoi le score est calculé : {terms}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC –&lt;/b&gt; {why}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC –&lt;/b&gt; {why}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; of the fit</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; de l’ajustement</translation>
  </message>
  <message>
   <source>&lt;b&gt;blind&lt;/b&gt;: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;aveugle&lt;/b&gt; : remettre pour voir le JaC</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>caméra illisible</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>pas de caméra ici</translation>
  </message>
  <message>
   <source>Three steps to a frame</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Une image en trois étapes</translation>
  </message>
  <message>
   <source>Click the two ends of a painted line, then Enter</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Cliquer les deux bouts d’une ligne peinte, puis Entrée</translation>
  </message>
  <message>
   <source>{keys}: points along every line, on its paint</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys} : des points le long de chaque ligne, sur sa peinture</translation>
  </message>
  <message>
   <source>{keys}, then Enter: take what the camera expects</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}, puis Entrée : prendre ce que la caméra attend</translation>
  </message>
  <message>
   <source>Put the three steps away for ever (Help has the user guide)</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Ranger les trois étapes pour toujours (le guide est dans Aide)</translation>
  </message>
  <message>
   <source>Put the three steps away</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Ranger les trois étapes</translation>
  </message>
  <message>
   <source>{step}, done</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{step}, fait</translation>
  </message>
  <message>
   <source>Enter calls it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Entrée exécute · ↑ ↓ choisissent · Échap ferme</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Rien ne s’appelle « {text} ».</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Une action, un élément, une image, une source, un dossier, un nombre</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Tout trouver</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Ce qui convient</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>activé</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>désactivé</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>cette installation est venue sans son guide</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>À propos de ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Annoter et auditer des calibrations de caméras de sport avec le protocole ProCC.</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>aucune caméra n’est chargée (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>chargez un second jeu de caméras pour les voir côte à côte (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>chargez un second jeu de caméras pour comparer (Ctrl+L)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Sans géométrie</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Fantôme de {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Accepter</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Regarder de près</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action not_visible]</extracomment>
   <translation>Pas visible ici</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Dessin de {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Couper ici : le reste devient</translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action ignore_finding]</extracomment>
   <translation>Ignorer ce constat</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Pas visible ici : revenir dessus</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Changer la classe en (échange avec une annotée)</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Point {number} de {title}</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Fusionner dans</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title}, non confirmé</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>
    <numerusform>{n} point</numerusform>
    <numerusform>{n} points</numerusform>
   </translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Annoter</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Juger</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Relire</translation>
  </message>
  <message>
   <source>Desks</source>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Postes de travail</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Images</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Plan du terrain</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Éléments</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/window/docks.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Caméras</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Scores</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Ajustement</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Vérification</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Repères</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/docks.py, the action plots]</extracomment>
   <translation>Graphiques</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Relecture</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Accord</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Chercher des mots dans cette page</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Le guide est en anglais.</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/guide.py, the action guide]</extracomment>
   <translation>Guide</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Titres</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_columns.py]</extracomment>
   <translation>{one} ou {other}</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Dans l’image</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py, procc_annotator/gui/window/keymap_dialog.py, the action keys]</extracomment>
   <translation>Touches</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Recherche : un mot ou une touche. Un clic fait ce que dit une ligne.</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Chercher dans les touches</translation>
  </message>
  <message>
   <source>Actions and their keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Actions et leurs touches</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Aucune touche, action ni élément ne contient « {text} ».</translation>
  </message>
  <message>
   <source>Choose an element</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Choisir un élément</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Vos propres touches</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Touches (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu} : {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Recherche : un mot ou une touche</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Choisir une ligne, puis presser ses touches</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Changer les touches</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Recherche</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Toutes les touches d’un coup</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Ajouter</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Seulement celles-ci</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Aucune touche</translation>
  </message>
  <message>
   <source>Usual keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Touches habituelles</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Exporter…</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Importer…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ Des touches qui appellent deux actions n’en appellent aucune : donnez-en d’autres à l’une d’elles.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Exporter les touches</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Importer des touches</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ aussi : {what}</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Nouvelles touches : pressez-les ici</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>{file} : {error} ; les touches restent ce qu’elles sont</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Action ou élément</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action} : {step}</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Panneau</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Paramètre</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ouvrir</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Image {number} sur {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Aller à cette image</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juger {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juger avec cette source</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ajustement continu : modèle {model}</translation>
  </message>
  <message>
   <source>Fit this model to the clicks; auto takes the simplest that they support</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ajuster ce modèle aux clics ; auto prend le plus simple qu’ils permettent</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Panneau {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ouvrir ce panneau et le mettre devant</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Seuil {px:g} px</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juger les éléments avec ce tau</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Barre d’outils</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Image
Luminosité, contraste, gamma, rehaussement des lignes : seul ce que vous voyez change</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>enregistré {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>
    <numerusform>NON ENREGISTRÉE : {n} image</numerusform>
    <numerusform>NON ENREGISTRÉES : {n} images</numerusform>
   </translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>enregistrement...</translation>
  </message>
  <message>
   <source>no changes</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>aucun changement</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Chercher dans les paramètres</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>{setting} : revenir à {value}</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Paramètres</translation>
  </message>
  <message>
   <source>All to their defaults</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Tout par défaut</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py, the action keymap]</extracomment>
   <translation>Changer les touches…</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Aucun paramètre ne contient « {text} ».</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>aucun de votre choix</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>sol ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Curseur en pixels de l’image ; le centre du pixel en haut à gauche est 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Curseur au sol du terrain, en mètres depuis son centre</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>À quelle distance la caméra active et la caméra comparée voient le curseur :
au sol, et en pixels de la taille d’évaluation</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Avec quelle sûreté la caméra ajustée connaît le point du sol au curseur : écart type
dans la pire direction, quelle que soit l’erreur du curseur lui-même</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>notation {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Caméra &gt; Arrêter de noter le jeu y met fin</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>comparaison {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>fantômes {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Échap y met fin</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Seuil tau : un élément passe si tous ses points sont plus proches (+ et -)</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Seuil tau</translation>
  </message>
  <message>
   <source>Top bar</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Barre supérieure</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>État de cette image (panneau Relecture)</translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Terrain : {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Cliquer pour en choisir un autre</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Déposez un dossier d’images ici</translation>
  </message>
  <message>
   <source>Annotations are read from and saved to SoccerNet JSON beside the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Les annotations sont lues et enregistrées en JSON SoccerNet à côté des images. Déposez plus tard un dossier de caméras pour les voir jugées d’après vos clics.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Ouvrir un récent</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Ouvrir un dossier…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Ouvrir une image…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Ouvrir une vidéo…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Essayer l’exemple</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Continuer avec</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Rien n’a encore été ouvert</translation>
  </message>
  <message>
   <source>unexpected error ({what}); the terminal says more</source>
   <extracomment>[procc_annotator/gui/worker.py]</extracomment>
   <translation>erreur inattendue ({what}) ; le terminal en dit plus</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/writing.py]</extracomment>
   <translation>ouvrez d’abord un dossier d’images</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>ce qui a été enregistré ailleurs</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>écrasé</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>comme trouvé</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>repris</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>enregistré</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Annoter toutes les images d’un dossier</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Annoter une seule image</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Annoter les images d’une vidéo sans les extraire auparavant</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Ouvrir l’exemple</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Ouvrir votre propre copie des images fournies avec le programme</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Ouvrir un second annotateur…</translation>
  </message>
  <message>
   <source>Draw and compare what somebody else clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Dessiner et comparer ce qu’une autre personne a cliqué sur les mêmes images</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Fermer le second annotateur</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>N’afficher à nouveau que les annotations de ce jeu de données</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[the field american_football, the menus]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Depuis un fichier…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Votre propre description : n’importe quel sport, voir le guide</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Passer au terrain qui convient</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Afficher le terrain qui connaît les classes annotées sur cette image</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Relire le fichier</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Se fait tout seul quand le fichier du terrain de ce jeu de données est écrit</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Enregistrer maintenant</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Toute modification terminée est enregistrée aussitôt ; ceci réessaie ce qui a échoué</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Importer des annotations…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Reprendre dans ce jeu, image par image, les annotations d’un autre programme ou jeu de données</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exporter sous…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Écrire les annotations pour un autre programme : CVAT, labelme, COCO, SoccerNet, masques</translation>
  </message>
  <message>
   <source>Export SoccerNet JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Exporter en JSON SoccerNet…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of SoccerNet JSON</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Écrire les annotations de toutes les images dans un dossier ou un zip de JSON SoccerNet</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Exporter le JaC du jeu…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Écrire le JaC de chaque image en CSV ou JSON</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Exporter la provenance…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Écrire dans un JSON d’accompagnement comment chaque point est né, et par qui</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Enregistrer l’image superposée…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Écrire l’image avec annotation, projection et légende en PNG, JPEG ou SVG</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Exporter la vue d’ensemble…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Écrire l’état, les nombres et le temps de chaque image en CSV</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Exporter les verdicts…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Écrire en CSV à qui la faute sur quelle image, avec le JaC et la plus grande erreur</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Exporter les constats…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Écrire en CSV ce que la vérification des classes a trouvé dans les images vérifiées jusqu’ici</translation>
  </message>
  <message>
   <source>Your name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Votre nom…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>Le nom que portent vos points, commentaires et versions</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Quitter</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Fermer la fenêtre ; tout est enregistré</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Annuler</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Revenir sur la dernière étape de cette image</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Rétablir</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Refaire l’étape</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Supprimer le point ou l’élément</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Retirer le point sélectionné ; à défaut, l’élément sélectionné</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Choisir tous les points</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Choisir tous les points de l’élément sélectionné, ou de l’image</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Abandonner</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Abandonner les points qui viennent d’être cliqués, puis lâcher la sélection</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Paramètres…</translation>
  </message>
  <message>
   <source>Theme, size of texts, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Thème, taille des textes, et comment la fenêtre dessine, ajuste et juge</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Avec les flèches</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Déplacer de 1 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px à droite</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px en haut</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px en bas</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Déplacer de 0.1 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px à droite</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px en haut</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px en bas</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Déplacer de 10 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px à droite</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px en haut</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px en bas</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px à gauche</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Déplacer de 100 px les points choisis ; si aucun ne l’est, le réticule</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px à droite</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px en haut</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px en bas</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Image suivante</translation>
  </message>
  <message>
   <source>Show the next picture</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Afficher l’image suivante</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Image précédente</translation>
  </message>
  <message>
   <source>Show the previous picture</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Afficher l’image précédente</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Suivante non terminée</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Aller à la prochaine image ni terminée ni approuvée</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Précédente non terminée</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Revenir à l’image précédente ni terminée ni approuvée</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Suivante rejetée</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Aller à la prochaine image renvoyée par un relecteur</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Plus mauvais JaC suivant</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>L’image au JaC le plus bas ; une fois de plus : la suivante, un peu meilleure</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Plus grande erreur suivante</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>L’image où un point a la plus grande erreur ; une fois de plus : la suivante, plus petite</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Suivante par désaccord</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>L’image où la source active et la source comparée sont le plus éloignées au sol ; une fois de plus : la suivante</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Vérification des classes</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Constat suivant</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Aller au prochain constat de la vérification, image par image</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Constat précédent</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Revenir au constat précédent</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Appliquer le premier remède</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Corriger le constat actuel : renommer, échanger, retirer le mauvais point, ou aller voir</translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[the action ignore_finding]</extracomment>
   <translation>Ne plus le montrer tant que les points de ses éléments ne changent pas</translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>Vérifier tout le jeu</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>Chercher les mauvaises classes dans toutes les images annotées</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Suivante sans annotation</translation>
  </message>
  <message>
   <source>Go on to the next frame where nothing is annotated</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Aller à la prochaine image où rien n’est annoté</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Précédente sans annotation</translation>
  </message>
  <message>
   <source>Go back to the frame before where nothing is annotated</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Revenir à l’image précédente où rien n’est annoté</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Première image</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Afficher la première image</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Dernière image</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Afficher la dernière image</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Plan</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Suivre le plan</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Trouver les caméras de toutes les images de ce plan, à partir de celle-ci dans les deux sens ; une fois de plus arrête</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Accepter le passage</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; doubtful frames and annotated ones are left out</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Annoter les images du plan, ou du passage marqué sur la bande, le long de leur suivi ; les images douteuses et les images annotées sont laissées de côté</translation>
  </message>
  <message>
   <source>Take back the accepted stretch</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Revenir sur le passage accepté</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Les images acceptées en dernier et non modifiées depuis redeviennent ce qu’elles étaient</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Dix images plus loin</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Avancer de dix images</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Dix images en arrière</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Reculer de dix images</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Image annotée suivante</translation>
  </message>
  <message>
   <source>Go on to the next frame of the shot that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Aller à la prochaine image annotée du plan</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Image annotée précédente</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Revenir à l’image annotée précédente</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Image douteuse suivante</translation>
  </message>
  <message>
   <source>Go on to the next frame whose track should be looked at</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Aller à la prochaine image dont le suivi est à regarder</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Image douteuse précédente</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Revenir à l’image douteuse précédente</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Lecture ou pause</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Montrer les images l’une après l’autre ; une fois de plus, ou toute modification, arrête</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Trouver une image…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Taper une partie du nom de l’image</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Mode aveugle</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Cacher la projection jusqu’à la remise de l’image, pour que la caméra n’attire pas les clics</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Imposer le mode aveugle au jeu de données</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Mode aveugle pour tous ceux qui annotent ce jeu ; le lever demande confirmation et est consigné</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Terminée</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Cette image est terminée ; en mode aveugle, cela montre la projection</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Approuver</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Un relecteur trouve cette image correcte</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Rejeter</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Un relecteur renvoie cette image ; dites pourquoi dans un commentaire</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>De nouveau en cours</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Cette image n’est finalement pas terminée</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Commentaire…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Écrire dans la discussion de cette image</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Versions antérieures…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Voir toutes les versions enregistrées de cette image et en reprendre une</translation>
  </message>
  <message>
   <source>Overview of the set…</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Vue d’ensemble du jeu…</translation>
  </message>
  <message>
   <source>Counts per status and class, progress, time per frame</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Nombres par état et par classe, avancement, temps par image</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Grouper les vues…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Dire d’après leurs noms quelles images montrent le même instant depuis plusieurs caméras</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Garder cette image de la vidéo</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture beside its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Écrire l’image de la vidéo comme fichier à côté de son annotation</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Copier de l’image précédente</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Reprendre les éléments de l’image annotée avant, déplacés comme la caméra ; ils attendent d’être confirmés</translation>
  </message>
  <message>
   <source>Confirm all copied elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Confirmer tous les éléments copiés</translation>
  </message>
  <message>
   <source>Copied elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Les éléments copiés comptent et sont enregistrés désormais</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Écarter les éléments non confirmés</translation>
  </message>
  <message>
   <source>Throw away what was copied and nobody touched</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Jeter ce qui a été copié et que personne n’a touché</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Régulariser tous les éléments</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Rééchantillonner chaque élément de l’image le long de sa ligne peinte</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Dessiner</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Les clics ajoutent des points à l’élément choisi</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Glisser, insérer et retirer des points</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Passer du dessin à l’édition</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Du dessin à l’édition et retour</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Élément suivant</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Choisir l’élément suivant du terrain</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Élément précédent</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Choisir l’élément précédent</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Trouver un élément…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Taper une partie du nom de l’élément</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Terminer l’élément</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Faire un élément des points qui viennent d’être cliqués (ou double-cliquer le dernier)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminer et rester</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminer l’élément sans passer au suivant</translation>
  </message>
  <message>
   <source>Take back last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Retirer le dernier point</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Retirer le point cliqué en dernier</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Supprimer l’élément</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Retirer l’élément sélectionné avec tous ses points</translation>
  </message>
  <message>
   <source>Confirm copied element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Confirmer l’élément copié</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>L’élément sélectionné compte et est enregistré désormais (en mode édition : Entrée)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Régulariser</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Rééchantillonner l’élément le long de sa ligne peinte : deux clics font un élément droit, cinq une courbe</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Fermer les écarts</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Prolonger les bouts de l’élément jusqu’au coin ou au bord de l’image qu’ils n’atteignent pas</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Inverser</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Retourner l’ordre des points de l’élément</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Dupliquer vers la classe symétrique</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Mettre une copie sous la classe du terrain tourné, à glisser à sa place</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Aimanter aux lignes</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click beside it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Les clics près d’une ligne peinte vont à son milieu (tenir Ctrl pour cliquer à côté)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Passer à l’élément suivant</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Après un élément terminé, choisir celui qui vient le plus probablement ensuite</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Deux clics terminent un élément droit</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Le second clic sur un élément droit le termine</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Dessiner d’abord, nommer ensuite</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Sans élément choisi, un clic commence une ligne ; une fois terminée, les éléments les plus probables sont proposés au stylet</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Épingler les éléments</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Seuls les points peuvent être glissés, pas les éléments entiers</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Fantômes</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Fantôme suivant</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Regarder de près le prochain élément que la caméra ajustée attend</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Fantôme précédent</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Regarder de près le précédent</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Accepter le fantôme</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Faire du fantôme un élément : des points sur sa ligne peinte, aucun là où elle est cachée (Entrée)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Accepter tous les fantômes</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Accepter tous les fantômes dont la ligne peinte se voit assez bien (Maj+Entrée tant que rien n’est en cours de dessin)</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Part visible pour tout accepter…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Quelle part de sa ligne peinte doit se voir pour qu’un fantôme soit accepté avec tous les autres</translation>
  </message>
  <message>
   <source>The ghost, or the chosen element, cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>Le fantôme, ou l’élément choisi, ne se voit pas sur cette image ; une fois de plus revient dessus</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Revenir sur « pas visible ici »</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>L’élément dit en dernier non visible sur cette image se voit peut-être quand même</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Afficher les fantômes</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Tracer des courbes pâles là où la caméra ajustée attend des éléments pas encore annotés</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Chercher la caméra dans l’image</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Là où rien n’est encore annoté, trouver la caméra sans un clic et montrer ses éléments comme fantômes ; rien n’est enregistré avant d’être accepté</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Dire quoi annoter ensuite</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Marquer sur le plan du terrain l’élément qui rendrait la caméra ajustée la plus sûre</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Ajuster à la fenêtre</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Montrer toute l’image</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Taille réelle</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Un pixel de l’image est un pixel de l’écran</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Zoom avant</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Agrandir (la molette le fait au curseur)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Zoom arrière</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Réduire (la molette le fait au curseur)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Déplacer la vue</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Le bouton gauche déplace l’image (ou tenir Espace, ou bouton du milieu) ; Échap y met fin</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Garder le zoom d’une image à l’autre</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Rester à cet endroit de l’image quand l’image change</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Cacher les superpositions</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Montrer l’image nue (ou tenir X)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Colorer selon</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Critère</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Les couleurs disent comment la caméra est jugée</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Classe</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Chaque élément dans sa propre couleur</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Provenance</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Les points selon leur origine : cliqués, aimantés, régularisés, copiés, déplacés</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Annotateur</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Les points selon qui les a posés</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Largeur peinte</translation>
  </message>
  <message>
   <source>Draw how wide the paint of the field's lines must appear, beside the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Tracer à côté de la projection la largeur que doit avoir la peinture des lignes du terrain</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Preuves de peinture</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Le long de chaque segment une bande : pleine où l’image montre de la peinture dessous, tiretée où la peinture passe à côté, de ce côté, pointillée où il n’y en a pas</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Loupe</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Garder la loupe au curseur (ou tenir Z ; elle vient aussi quand un point est glissé)</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Tourner le plan vers la caméra</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint; the half that is out of sight leaves its room to the other one</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Le plan a en bas le côté où se tient la caméra, et ce qu’elle ne voit pas est pâle ; la moitié hors de vue laisse sa place à l’autre</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bande d’images</translation>
  </message>
  <message>
   <source>Below the picture: of a video, or of frames that follow one another, how their cameras do and where they are annotated; of other frames small pictures with their states</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Sous l’image : pour une vidéo ou des images qui se suivent, comment vont leurs caméras et où elles sont annotées ; pour d’autres, des vignettes avec leur état</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set as plots, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Erreurs et JaC de l’image ou du jeu en graphiques, pour toutes les sources affichées</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Panneaux pour annoter</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Éléments, constats de la vérification, points de repère</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Panneaux pour juger</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Scores, sources de caméras, ajustement, graphiques</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Panneaux pour relire</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>État, commentaires et temps, un second annotateur</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Cacher tous les panneaux</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Donner toute la place à l’image</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Clavier vers les panneaux</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Dans l’image, Tab parcourt les fantômes ; ceci mène le clavier aux panneaux</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Clavier vers la partie suivante</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Image, panneaux, barres : le clavier en fait le tour</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Clavier vers la partie précédente</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Le même tour à l’envers</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Réinitialiser la disposition</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Remettre les panneaux où ils étaient au début</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Charger des caméras…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Juger un dossier de caméras ou d’homographies d’après les annotations</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Charger un fichier de caméra…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Juger un seul fichier de caméra, ou un zip de plusieurs</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Source de caméras suivante</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Juger avec la source chargée suivante</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Source de caméras précédente</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Juger avec la précédente</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Échanger avec la source comparée</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Juger avec la source comparée, et comparer avec celle-ci (ou taper la virgule ; la tenir pour voir seulement)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Tracer les autres sources</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes beside the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Tracer les sources cochées du panneau Caméras en fil de fer à côté de l’active</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Vue partagée</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Tracer la source active à gauche d’une séparation, la source comparée à droite</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>Désaccord</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>De combien de mètres la source active et la source comparée voient chaque pixel à distance au sol</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Carte d’incertitude</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Où sur le terrain la caméra ajustée est bonne à 0.1, 0.5 et 1 m</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajustement continu</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajuster une caméra aux clics de l’image après chaque modification</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Enregistrer l’ajustement comme caméra de l’image</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Écrire la caméra ajustée aux clics dans le dossier cameras/fitted du jeu de données</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Dimensions du terrain…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Longueur et largeur du terrain de ce stade, saisies ou trouvées d’après toutes les images ; et où sur ses lignes sont les clics</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Seuil : 0.5 px de plus</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Permettre de plus grandes distances</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Seuil : 0.5 px de moins</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Ne permettre que de plus petites distances</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[the menus, the setting protocol]</extracomment>
   <translation>Protocole</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>L’évaluation officielle SoccerNet, bizarreries comprises</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>La définition de l’article, sans les artefacts du code officiel</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Éléments hors du sol</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Compter comme manqués</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Les buts, paniers et filets qu’une homographie ne peut pas projeter comptent contre elle</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Laisser de côté</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Les buts, paniers et filets qu’une homographie ne peut pas projeter ne sont pas comptés</translation>
  </message>
  <message>
   <source>Camera fault</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Faute de la caméra</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>La caméra active est fausse sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>Annotation fault</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Faute de l’annotation</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Les clics sont faux sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>Fine</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Correct</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Caméra et clics sont justes sur cette image ; une fois de plus retire le verdict</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Note sur le verdict…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Dire en quelques mots ce qui est faux ; c’est exporté avec le verdict</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Arrêter de noter le jeu</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Arrêter de calculer le JaC des images pas encore ouvertes et de comparer les sources</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Tout trouver…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>La palette de commandes : toute action, tout élément, image, source de caméras et dossier récent, par quelques lettres de son nom</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Montrer toutes les actions et leurs touches sur une feuille</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Donner d’autres touches aux actions et aux éléments, ou prendre celles d’un autre programme</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>Le guide fourni avec le programme ; il n’a pas besoin du réseau</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Version</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Apparence</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Thème</translation>
  </message>
  <message>
   <source>Light, dark, or as the system has it</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Clair, sombre, ou comme le système</translation>
  </message>
  <message>
   <source>As the system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Comme le système</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Clair</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Sombre</translation>
  </message>
  <message>
   <source>Size of texts</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Taille des textes</translation>
  </message>
  <message>
   <source>How large texts are, of what the system says; from the next start on</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>La taille des textes, par rapport à celle du système ; dès le prochain démarrage</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Langue</translation>
  </message>
  <message>
   <source>The language of the window; from the next start on. Files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>La langue de la fenêtre ; dès le prochain démarrage. Les fichiers restent ce qu’ils sont</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Ce que disent les couleurs sur l’image</translation>
  </message>
  <message>
   <source>Your name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Votre nom</translation>
  </message>
  <message>
   <source>Whose name points, comments and versions bear; empty: that of the system's user</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Le nom que portent points, commentaires et versions ; vide : celui de l’utilisateur du système</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Jugement</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Seuil</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>À quelle distance de son élément un point annoté peut être, en px de la taille d’évaluation</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Comment les caméras sont jugées : comme l’évaluation officielle, bizarreries comprises, ou selon la définition de l’article</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>soccernet (officiel)</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (article)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Comment comptent les éléments qu’une homographie ne peut pas projeter : buts, paniers, filets</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modèle de l’ajustement continu</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>La caméra ajustée aux clics ; auto : la plus simple qu’ils permettent</translation>
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
   <translation>Juger l’ajustement</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Si l’ajustement est jugé là où il n’y a rien d’autre</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Part visible pour tout accepter</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Quelle part de la ligne d’un fantôme doit se voir pour l’accepter avec tous les autres</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Football américain (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de touche proche</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de touche lointaine</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks proches</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks lointaines</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Ligne de but gauche</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 5 yards gauche</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 10 yards gauche</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 15 yards gauche</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 20 yards gauche</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 25 yards gauche</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 30 yards gauche</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 35 yards gauche</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 40 yards gauche</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 45 yards gauche</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 50 yards</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Ligne de but droite</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 5 yards droite</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 10 yards droite</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 15 yards droite</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 20 yards droite</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 25 yards droite</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 30 yards droite</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 35 yards droite</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 40 yards droite</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne des 45 yards droite</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Barre transversale gauche</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But gauche, montant gauche</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But gauche, montant droit</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Barre transversale droite</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But droit, montant gauche</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>But droit, montant droit</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai gauche</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai droite</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longueur avec les deux zones d’en-but</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Profondeur d’une zone d’en-but</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yard</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Ligne de yard à la ligne de touche</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hash marks à la ligne de touche</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marque d’essai à la ligne de but</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longueur de la marque d’essai</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Largeur du but</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Hauteur de la barre transversale</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Montants au-dessus de la barre</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Largeur des lignes</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Largeur de la ligne de but</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Largeur du bord</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Moitié gauche</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Moitié droite</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>But gauche</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>But droit</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Athlétisme (piste de 400 m)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordure</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de couloir 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloir 8, bord extérieur</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloir 9, bord extérieur</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne d’arrivée</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 110 m haies</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ des 3000 m et 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Ligne de rabattement</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 200 m, couloir 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 400 m, couloir 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départ du 800 m, couloir 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne intérieure</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint, ligne 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Longueur sur huit couloirs</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Largeur sur huit couloirs</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Largeur d’un couloir</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Couloirs</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Arrivée et départs</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Départs du 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Piste de sprint</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Basketball (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne médiane</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Rond central</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche, côté lointain</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne de lancer franc gauche</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche, côté proche</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de lancer franc gauche</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite, côté lointain</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Ligne de lancer franc droite</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite, côté proche</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de lancer franc droit</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arc à trois points gauche</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points gauche, droite lointaine</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points gauche, droite proche</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arc à trois points droit</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points droite, droite lointaine</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Trois points droite, droite proche</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau gauche</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau gauche</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de non-charge gauche</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau droit</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau droit</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Demi-cercle de non-charge droit</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectangle du panneau gauche</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centre de l’anneau gauche</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectangle du panneau droit</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centre de l’anneau droit</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Longueur</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Ligne médiane au-delà des touches</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Rayon du cercle</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Longueur de la raquette</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur de la raquette</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rayon à trois points</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points à la ligne de touche</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Rayon de non-charge</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panneau à la ligne de fond</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur du panneau</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur du panneau</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Bord inférieur du panneau</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Largeur du rectangle du panneau</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur du rectangle du panneau</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Hauteur de l’anneau</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rayon de l’anneau</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anneau au panneau</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette gauche</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Raquette droite</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points gauche</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Ligne à trois points droite</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panier gauche</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Panier droit</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Basketball (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Cercle de lancer franc gauche</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Cercle de lancer franc droit</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arc de zone restreinte gauche</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arc de zone restreinte droit</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rond central intérieur</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark lointaine gauche</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark lointaine droite</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark proche gauche</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark proche droite</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rayon du cercle intérieur</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Rayon de la zone restreinte</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Hash mark à la ligne de fond</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Longueur d’une hash mark</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Futsal</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne de touche proche</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne de touche lointaine</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Ligne médiane</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ligne de surface gauche</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Ligne de surface droite</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But gauche, poteau lointain</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But gauche, poteau proche</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But droit, poteau lointain</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>But droit, poteau proche</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point central</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty gauche</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty gauche</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty droit</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty droit</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin lointain gauche</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin proche gauche</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin lointain droit</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arc de coin proche droit</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, gauche extérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, gauche intérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, droite intérieure</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement lointaine, droite extérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, gauche extérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, gauche intérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, droite intérieure</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zone de remplacement proche, droite extérieure</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Largeur des poteaux</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rayon de la surface de réparation</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Point de penalty à la ligne de but</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Second point de penalty à la ligne de but</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Rayon du rond central</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Rayon des arcs de coin</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Hauteur du but</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Terrain</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Surface de réparation gauche</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Surface de réparation droite</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Points</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Coins</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zones de remplacement</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Handball</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ligne latérale proche</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Ligne latérale lointaine</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Zone d’engagement</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de surface de but gauche</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 7 mètres gauche</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 4 mètres gauche</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de surface de but droite</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 7 mètres droite</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne des 4 mètres droite</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement lointaine, gauche</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement lointaine, droite</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement proche, gauche</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Ligne de changement proche, droite</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rayon de la surface de but</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Rayon de la ligne de jet franc</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Surface de but gauche</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Surface de but droite</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Lignes de changement</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Hockey sur glace (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande latérale proche</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande latérale lointaine</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande de fond gauche</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bande de fond droite</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin proche gauche</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin lointain gauche</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin proche droit</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Coin lointain droit</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue gauche</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue droite</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle proche gauche</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle lointain gauche</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle proche droit</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercle lointain droit</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone de but gauche</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But gauche, poteau gauche</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But gauche, poteau droit</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone de but droite</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But droit, poteau gauche</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>But droit, poteau droit</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze gauche, côté proche</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze gauche, côté lointain</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze droit, côté proche</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze droit, côté lointain</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone des arbitres, proche</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zone des arbitres, lointaine</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point central</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone proche gauche</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone lointain gauche</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone proche droit</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone lointain droit</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre proche gauche</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre lointain gauche</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre proche droit</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre lointain droit</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande proche</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande lointaine</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande gauche</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur de la bande droite</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin proche gauche</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin lointain gauche</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin proche droit</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bord supérieur du coin lointain droit</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon des coins</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Hauteur des bandes</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Ligne de but à la bande de fond</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Ligne bleue à la bande de fond</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon des cercles d’engagement</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point de zone à la ligne de but</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point neutre à la ligne bleue</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Point au grand axe</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon de la zone de but</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Largeur de la zone de but</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Rayon de la zone des arbitres</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze à la ligne de but</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapèze à la bande de fond</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Largeur des lignes bleues et médiane</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Bandes</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Lignes</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Cercles d’engagement</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Points d’engagement</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Haut des bandes</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Hockey sur glace (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Ligne bleue à la ligne de but</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Football</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, côté proche</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, avant</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface gauche, côté lointain</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, côté proche</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, avant</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface droite, côté lointain</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Arc de surface gauche</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Arc de surface droit</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, côté proche</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, avant</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but gauche, côté lointain</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, côté proche</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, avant</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Surface de but droite, côté lointain</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin lointain gauche (pied)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin proche gauche (pied)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin lointain droit (pied)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Drapeau de coin proche droit (pied)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profondeur de la surface de réparation</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Largeur de la surface de réparation</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profondeur de la surface de but</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Largeur de la surface de but</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>But indéterminé</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Ligne indéterminée</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tennis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de fond gauche</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de fond droite</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de double lointaine</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de double proche</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de simple lointaine</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de simple proche</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service gauche</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service droite</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne médiane de service</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Haut du filet</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet lointain</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet proche</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Sangle centrale du filet</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Piquet de simple lointain</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Piquet de simple proche</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marque centrale gauche</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marque centrale droite</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur du simple</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Ligne de service au filet</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur de la ligne de fond</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Largeur de la ligne médiane</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Longueur de la marque centrale</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet à la sangle</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet aux poteaux</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Hauteur du filet aux piquets de simple</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poteau de filet à la ligne latérale</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Carrés de service</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Filet</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Volleyball</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque gauche</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque droite</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Bande supérieure du filet</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Bande inférieure du filet</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne lointaine</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne proche</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau lointain</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau proche</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement lointain gauche</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement proche gauche</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement lointain droit</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement proche droit</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service lointaine gauche</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service proche gauche</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service lointaine droite</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service proche droite</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ligne d’attaque à la ligne médiane</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur du filet</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur de la toile du filet</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longueur du filet</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antenne au-dessus du filet</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poteau à la ligne latérale</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Hauteur des poteaux</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongement de la ligne d’attaque</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marque de service à la ligne de fond</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longueur de la marque de service</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marques hors du terrain</translation>
  </message>
 </context>
</TS>
