<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Archivo</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>Editar</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/context_menu.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Elemento</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Ver</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/palette_entries.py, the menus]</extracomment>
   <translation>Cámara</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>Ayuda</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>{n} elemento, simetrías: {turns}</numerusform>
    <numerusform>{n} elementos, simetrías: {turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>Aún no hay ningún campo que mostrar.</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}: {value:.10g} m (las reglas permiten de {least:g} a {most:g} m)</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... y {n} más</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>ninguna</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Rueda</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>zoom en el cursor</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Dos dedos</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>desplazar; al pellizcar, zoom</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mayús + rueda</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>desplazar a los lados, como una rueda inclinada</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Espacio + arrastrar</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>desplazar</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Botón central</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mantener X</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>ocultar todas las superposiciones</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mantener Z</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>lupa: ocho veces los píxeles de la imagen</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mantener ,</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>mirar la fuente de cámaras comparada</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Pulsar ,</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>juzgar con la fuente comparada, comparar con esta</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mantener Ctrl</translation>
  </message>
  <message>
   <source>click beside the line: no snapping</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>marcar junto a la línea: sin ajuste</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + arrastrar una línea</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>cámara: sigue, y el lugar queda como estaca</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Ctrl+Alt + clic en una estaca</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>cámara: quitar la estaca</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Flechas</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>retícula: las teclas señalan; si hay puntos elegidos, se mueven ellos</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Espacio en la retícula</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>lo que hace allí un clic (con Ctrl: sin ajuste)</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Botón derecho</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>menú de lo que hay bajo el cursor</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Intro</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>aceptar el fantasma actual</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mayús+Intro</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>aceptar todos los fantasmas</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Clic</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>dibujar: añadir un punto</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Doble clic</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>dibujar: terminar</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Arrastrar un punto</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: moverlo</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mayús+clic en un punto</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: elegir varios</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Arrastrar sobre un lugar vacío</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: elegir los puntos de dentro</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Arrastrar una línea</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: mover el elemento, salvo que estén fijados</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+clic en una línea</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: insertar un punto</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Alt+Mayús+clic</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>editar: quitar el punto</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Clic o arrastrar en la tira</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>ir a una imagen</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Rueda sobre la tira</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>zoom; con Mayús, desplazar</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>Mayús+arrastrar en la tira</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/gestures.py]</extracomment>
   <translation>marcar un tramo (un doble clic lo suelta)</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>lo que se mantiene pulsado en la imagen</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Habituales</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Para zurdos</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Como CVAT</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Como labelme</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>se esperaba un objeto con "actions" y "elements"</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" y "elements": se esperaban objetos</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: {value!r} no es una tecla; se esperaba una como {one}</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}: se esperaba una lista de teclas, como {one}</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>Paneles</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} ya existe y dice otra cosa.</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{text}.</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>¿Borrar {what}?</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Borrar</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Reemplazarlo</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Conservarlo</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} imagen no está guardada, y guardar acaba de fallar otra vez.</numerusform>
    <numerusform>{n} imágenes no están guardadas, y guardar acaba de fallar otra vez.</numerusform>
   </translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Quedarse</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Cerrar y perderlas</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Quitar este mensaje</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Recargar lo suyo</translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Mostrar lo que hay en el archivo; deshacer devuelve su versión</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Sobrescribir con lo mío</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Escribir lo que ve en pantalla sobre el archivo</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>Esta imagen no se puede editar. {problem}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>Ajuste y fantasmas</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>Anotación</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/settings.py, procc_annotator/gui/window/rail.py, the setting evidence]</extracomment>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>no camera</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>sin cámara</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Índice de Jaccard de esta imagen con tau</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>El conjunto de cámaras que se juzga (C cambia)</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>Con qué se calcula la puntuación: {terms}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC –&lt;/b&gt; {why}</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC –&lt;/b&gt; {why}</translation>
  </message>
  <message>
   <source>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; of the fit</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;JaC {jac:.3f}&lt;/b&gt; del ajuste</translation>
  </message>
  <message>
   <source>&lt;b&gt;blind&lt;/b&gt;: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>&lt;b&gt;ciego&lt;/b&gt;: entregar para ver el JaC</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>cámara ilegible</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/window/camera_bar.py]</extracomment>
   <translation>aquí no hay cámara</translation>
  </message>
  <message>
   <source>Three steps to a frame</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Una imagen en tres pasos</translation>
  </message>
  <message>
   <source>Click the two ends of a painted line, then Enter</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Marcar los dos extremos de una línea pintada y luego Intro</translation>
  </message>
  <message>
   <source>{keys}: points along every line, on its paint</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys}: puntos a lo largo de cada línea, sobre su pintura</translation>
  </message>
  <message>
   <source>{keys}, then Enter: take what the camera expects</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{keys} y luego Intro: tomar lo que espera la cámara</translation>
  </message>
  <message>
   <source>Put the three steps away for ever (Help has the user guide)</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Quitar los tres pasos para siempre (la guía está en Ayuda)</translation>
  </message>
  <message>
   <source>Put the three steps away</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>Quitar los tres pasos</translation>
  </message>
  <message>
   <source>{step}, done</source>
   <extracomment>[procc_annotator/gui/window/coach.py]</extracomment>
   <translation>{step}, hecho</translation>
  </message>
  <message>
   <source>Enter calls it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Intro lo ejecuta · ↑ ↓ eligen · Esc cierra</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Nada se llama «{text}».</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Una acción, elemento, imagen, fuente de cámaras, carpeta o número</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Buscar todo</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Lo que encaja</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>activado</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>desactivado</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>esta instalación vino sin su guía</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>Acerca de ProCC Annotator</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
Anotar y auditar calibraciones de cámaras deportivas con el protocolo ProCC.</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>no hay cámaras cargadas (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>cargue un segundo conjunto de cámaras para verlos lado a lado (Ctrl+L)</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>cargue un segundo conjunto de cámaras para comparar (Ctrl+L)</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Sin geometría</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Fantasma de {title}</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Aceptar</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Mirar de cerca</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action not_visible]</extracomment>
   <translation>No visible aquí</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Dibujando {title}</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Dividir aquí: el resto pasa a ser</translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py, the action ignore_finding]</extracomment>
   <translation>Ignorar este hallazgo</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>No visible aquí: retirar</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Cambiar la clase a (intercambia con una anotada)</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Punto {number} de {title}</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>Unir con</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>{title}, sin confirmar</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/window/context_menu.py]</extracomment>
   <translation>
    <numerusform>{n} punto</numerusform>
    <numerusform>{n} puntos</numerusform>
   </translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Anotar</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Juzgar</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Revisar</translation>
  </message>
  <message>
   <source>Desks</source>
   <extracomment>[procc_annotator/gui/window/desk_switch.py]</extracomment>
   <translation>Puestos de trabajo</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Imágenes</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Mapa del campo</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Elementos</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/window/docks.py, procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Cámaras</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Puntuación</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Ajuste</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Comprobación</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Referencias</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/docks.py, the action plots]</extracomment>
   <translation>Gráficos</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Revisión</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/docks.py]</extracomment>
   <translation>Concordancia</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Buscar palabras en esta página</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>La guía está en inglés.</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/guide.py, the action guide]</extracomment>
   <translation>Guía</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/guide.py]</extracomment>
   <translation>Títulos</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_columns.py]</extracomment>
   <translation>{one} o {other}</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>En la imagen</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py, procc_annotator/gui/window/keymap_dialog.py, the action keys]</extracomment>
   <translation>Teclas</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Búsqueda: una palabra o una tecla. Un clic hace lo que dice la fila.</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Buscar en las teclas</translation>
  </message>
  <message>
   <source>Actions and their keys</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Acciones y sus teclas</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Ninguna tecla, acción ni elemento tiene «{text}».</translation>
  </message>
  <message>
   <source>Choose an element</source>
   <extracomment>[procc_annotator/gui/window/key_sheet.py]</extracomment>
   <translation>Elegir un elemento</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Teclas propias</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Teclas (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}: {action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Búsqueda: una palabra o una tecla</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Elija una fila y pulse sus teclas</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Cambiar teclas</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Búsqueda</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Todas las teclas a la vez</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Añadir</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Solo estas</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Ninguna tecla</translation>
  </message>
  <message>
   <source>Usual keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Teclas habituales</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Exportar…</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Importar…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ Las teclas que llaman a dos acciones no llaman a ninguna: dé otras a una de ellas.</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Exportar teclas</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Importar teclas</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>⚠ también: {what}</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Teclas nuevas: púlselas aquí</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>{file}: {error}; las teclas quedan como están</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/keymap_dialog.py]</extracomment>
   <translation>Acción o elemento</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}: {step}</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Panel</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ajuste</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Abrir</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Imagen {number} de {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ir a esta imagen</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juzgar {source}</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juzgar con esta fuente</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ajuste continuo: modelo {model}</translation>
  </message>
  <message>
   <source>Fit this model to the clicks; auto takes the simplest that they support</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Ajustar este modelo a los clics; auto toma el más sencillo que permiten</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Panel {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Abrir este panel y traerlo al frente</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Umbral {px:g} px</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/palette_entries.py]</extracomment>
   <translation>Juzgar los elementos con este tau</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Barra de herramientas</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/rail.py]</extracomment>
   <translation>Imagen
Brillo, contraste, gamma, realce de líneas: solo cambia lo que usted ve</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>guardado {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>
    <numerusform>SIN GUARDAR: {n} imagen</numerusform>
    <numerusform>SIN GUARDAR: {n} imágenes</numerusform>
   </translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>guardando...</translation>
  </message>
  <message>
   <source>no changes</source>
   <extracomment>[procc_annotator/gui/window/save_state.py]</extracomment>
   <translation>sin cambios</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Buscar en los ajustes</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>{setting}: volver a {value}</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Ajustes</translation>
  </message>
  <message>
   <source>All to their defaults</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Todo por defecto</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py, the action keymap]</extracomment>
   <translation>Cambiar teclas…</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>Ningún ajuste tiene «{text}».</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/settings_dialog.py]</extracomment>
   <translation>ninguno propio</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>suelo ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cursor en píxeles de la imagen; el centro del píxel superior izquierdo es 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Cursor sobre el suelo del campo, en metros desde su centro</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>A qué distancia ven el cursor la cámara activa y la comparada:
sobre el suelo, y en píxeles del tamaño de evaluación</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Con qué seguridad conoce la cámara ajustada el punto del suelo en el cursor: desviación
típica en la peor dirección, sea cual sea el error del propio cursor</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>puntuando {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Cámara &gt; Detener la puntuación del conjunto lo termina</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>comparando {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>fantasmas {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status_report.py]</extracomment>
   <translation>Esc lo termina</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Umbral tau: un elemento pasa si todos sus puntos están más cerca (+ y -)</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/tau_control.py]</extracomment>
   <translation>Umbral tau</translation>
  </message>
  <message>
   <source>Top bar</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Barra superior</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Estado de esta imagen (panel Revisión)</translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Campo: {field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>Clic para elegir otro</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Suelte aquí una carpeta de imágenes</translation>
  </message>
  <message>
   <source>Annotations are read from and saved to SoccerNet JSON beside the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Las anotaciones se leen y guardan como JSON de SoccerNet junto a las imágenes. Suelte más tarde una carpeta de cámaras para verlas juzgadas con sus clics.</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Abrir reciente</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>Abrir carpeta…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>Abrir imagen…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>Abrir vídeo…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Probar el ejemplo</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Continuar con</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>Aún no se ha abierto nada</translation>
  </message>
  <message>
   <source>unexpected error ({what}); the terminal says more</source>
   <extracomment>[procc_annotator/gui/worker.py]</extracomment>
   <translation>error inesperado ({what}); el terminal dice más</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/writing.py]</extracomment>
   <translation>abra primero una carpeta de imágenes</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>lo que se guardó en otra parte</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>sobrescrito</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>como se encontró</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>retirado</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/session/dataset/workspace.py]</extracomment>
   <translation>guardado</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>Anotar todas las imágenes de una carpeta</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>Anotar una sola imagen</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>Anotar imágenes de un vídeo sin extraerlas antes</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Abrir el ejemplo</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>Abrir su propia copia de las imágenes que trae el programa</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Abrir segundo anotador…</translation>
  </message>
  <message>
   <source>Draw and compare what somebody else clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>Dibujar y comparar lo que otra persona marcó en las mismas imágenes</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Cerrar segundo anotador</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>Mostrar de nuevo solo las anotaciones de este conjunto</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[the field american_football, the menus]</extracomment>
   <translation>Campo</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Desde un archivo…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>Una descripción propia: cualquier deporte, véase la guía</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Cambiar al campo que encaja</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>Mostrar el campo que conoce las clases anotadas en esta imagen</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Leer el archivo otra vez</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>Ocurre por sí solo cuando se escribe el archivo del campo de este conjunto</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>Guardar ahora</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>Cada cambio terminado se guarda al momento; esto vuelve a intentar lo que falló</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Importar anotaciones…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>Tomar, imagen por imagen, las anotaciones de otro programa o conjunto</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Exportar como…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>Escribir las anotaciones para otro programa: CVAT, labelme, COCO, SoccerNet, máscaras</translation>
  </message>
  <message>
   <source>Export SoccerNet JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Exportar JSON de SoccerNet…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of SoccerNet JSON</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>Escribir las anotaciones de todas las imágenes como carpeta o zip de JSON de SoccerNet</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Exportar el JaC del conjunto…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>Escribir el JaC de cada imagen como CSV o JSON</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Exportar procedencia…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>Escribir en un JSON adjunto cómo surgió cada punto y por obra de quién</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Guardar imagen superpuesta…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>Escribir la imagen con anotación, proyección y leyenda como PNG, JPEG o SVG</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Exportar resumen…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>Escribir el estado, los recuentos y el tiempo de cada imagen como CSV</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Exportar veredictos…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>Escribir como CSV de quién es el fallo en cada imagen, con el JaC y el mayor error</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Exportar hallazgos…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>Escribir como CSV lo que halló la revisión de clases en las imágenes revisadas hasta ahora</translation>
  </message>
  <message>
   <source>Your name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>Su nombre…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>El nombre que llevan sus puntos, comentarios y versiones</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Salir</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>Cerrar la ventana; todo está guardado</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Deshacer</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>Retirar el último paso de esta imagen</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Rehacer</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>Hacer el paso otra vez</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Borrar punto o elemento</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>Quitar el punto seleccionado; si no hay, el elemento seleccionado</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Elegir todos los puntos</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>Elegir todos los puntos del elemento seleccionado, o de la imagen</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Cancelar</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>Descartar los puntos recién marcados y después soltar la selección</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Ajustes…</translation>
  </message>
  <message>
   <source>Theme, size of texts, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>Tema, tamaño de los textos, y cómo dibuja, ajusta y juzga la ventana</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>Con las flechas</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>1 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>Mover 1 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>1 px a la derecha</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>1 px arriba</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>1 px abajo</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>0.1 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>Mover 0.1 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>0.1 px a la derecha</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>0.1 px arriba</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>0.1 px abajo</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>10 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>Mover 10 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>10 px a la derecha</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>10 px arriba</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>10 px abajo</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>100 px a la izquierda</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>Mover 100 px los puntos elegidos; si no hay ninguno, la retícula</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>100 px a la derecha</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>100 px arriba</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>100 px abajo</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Imagen siguiente</translation>
  </message>
  <message>
   <source>Show the next picture</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>Mostrar la imagen siguiente</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Imagen anterior</translation>
  </message>
  <message>
   <source>Show the previous picture</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>Mostrar la imagen anterior</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Siguiente sin terminar</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>Ir a la próxima imagen que no está terminada ni aprobada</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Anterior sin terminar</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>Volver a la imagen anterior que no está terminada ni aprobada</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Siguiente rechazada</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>Ir a la próxima imagen que devolvió un revisor</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>Siguiente peor JaC</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>La imagen con el JaC más bajo; otra vez: la siguiente mejor</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>Siguiente mayor error</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>La imagen con el mayor error de un punto; otra vez: la del siguiente menor</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>Siguiente por desacuerdo</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>La imagen en que la fuente activa y la comparada más se separan sobre el suelo; otra vez: la siguiente</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>Revisión de clases</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Hallazgo siguiente</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>Ir a lo siguiente que halló la revisión, de imagen en imagen</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Hallazgo anterior</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>Volver al hallazgo anterior</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Aplicar el primer remedio</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>Reparar el hallazgo actual: cambiar la clase, intercambiar, quitar el punto malo, o mirarlo</translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[the action ignore_finding]</extracomment>
   <translation>No mostrarlo más hasta que cambien los puntos de sus elementos</translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>Revisar todo el conjunto</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[the action check_set]</extracomment>
   <translation>Buscar clases equivocadas en todas las imágenes anotadas</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Siguiente sin anotación</translation>
  </message>
  <message>
   <source>Go on to the next frame where nothing is annotated</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>Ir a la próxima imagen en que no hay nada anotado</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Anterior sin anotación</translation>
  </message>
  <message>
   <source>Go back to the frame before where nothing is annotated</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>Volver a la imagen anterior en que no hay nada anotado</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Primera imagen</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>Mostrar la primera imagen</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Última imagen</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>Mostrar la última imagen</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>Plano</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Seguir el plano</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>Hallar las cámaras de todas las imágenes de este plano, desde esta en ambos sentidos; otra vez lo detiene</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Aceptar el tramo</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; doubtful frames and annotated ones are left out</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>Anotar las imágenes del plano, o del tramo marcado en la tira, a lo largo de su seguimiento; las dudosas y las anotadas se dejan fuera</translation>
  </message>
  <message>
   <source>Take back the accepted stretch</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Retirar el tramo aceptado</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>Las imágenes aceptadas en último lugar y no editadas desde entonces vuelven a ser como eran</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Diez imágenes adelante</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>Avanzar diez imágenes</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Diez imágenes atrás</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>Retroceder diez imágenes</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Siguiente imagen anotada</translation>
  </message>
  <message>
   <source>Go on to the next frame of the shot that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>Ir a la próxima imagen anotada del plano</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Anterior imagen anotada</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>Volver a la imagen anotada anterior</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Siguiente imagen dudosa</translation>
  </message>
  <message>
   <source>Go on to the next frame whose track should be looked at</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>Ir a la próxima imagen cuyo seguimiento conviene mirar</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Anterior imagen dudosa</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>Volver a la imagen dudosa anterior</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>Reproducir o pausar</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>Mostrar las imágenes una tras otra; otra vez, o cualquier cambio, lo detiene</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Buscar imagen…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>Escribir una parte del nombre de la imagen</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Modo ciego</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>Ocultar la proyección hasta entregar la imagen, para que la cámara no atraiga los clics</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Fijar el conjunto en modo ciego</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>Modo ciego para todos los que anotan este conjunto; levantarlo pide confirmación y queda registrado</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Terminada</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>Esta imagen está terminada; en modo ciego eso muestra la proyección</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Aprobar</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>Un revisor da por buena esta imagen</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Rechazar</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>Un revisor devuelve esta imagen; diga por qué en un comentario</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>De nuevo en curso</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>Al final esta imagen no está terminada</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Comentario…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>Escribir en el hilo de esta imagen</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Versiones anteriores…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>Ver todas las versiones guardadas de esta imagen y recuperar una</translation>
  </message>
  <message>
   <source>Overview of the set…</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Resumen del conjunto…</translation>
  </message>
  <message>
   <source>Counts per status and class, progress, time per frame</source>
   <extracomment>[the action overview]</extracomment>
   <translation>Recuentos por estado y clase, avance, tiempo por imagen</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Agrupar vistas…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>Decir por sus nombres qué imágenes muestran un mismo instante desde distintas cámaras</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Conservar esta imagen del vídeo</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture beside its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>Escribir la imagen del vídeo como archivo junto a su anotación</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Copiar de la imagen anterior</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>Tomar elementos de la imagen anotada antes, movidos como se movió la cámara; esperan confirmación</translation>
  </message>
  <message>
   <source>Confirm all copied elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Confirmar todos los elementos copiados</translation>
  </message>
  <message>
   <source>Copied elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>Los elementos copiados cuentan y se guardan desde ahora</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Descartar elementos sin confirmar</translation>
  </message>
  <message>
   <source>Throw away what was copied and nobody touched</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>Tirar lo que se copió y nadie tocó</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Regularizar todos los elementos</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>Volver a muestrear cada elemento de la imagen a lo largo de su línea pintada</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Dibujar</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>Los clics añaden puntos al elemento elegido</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>Arrastrar, insertar y quitar puntos</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>Cambiar entre dibujar y editar</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>De dibujar a editar y vuelta</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Elemento siguiente</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>Elegir el elemento siguiente del campo</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Elemento anterior</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>Elegir el elemento anterior</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Buscar elemento…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>Escribir una parte del nombre del elemento</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Terminar elemento</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>Hacer un elemento de los puntos recién marcados (o doble clic en el último)</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminar y quedarse</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>Terminar el elemento sin pasar al siguiente</translation>
  </message>
  <message>
   <source>Take back last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>Retirar el último punto</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>Quitar el último punto marcado</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Borrar elemento</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>Quitar el elemento seleccionado con todos sus puntos</translation>
  </message>
  <message>
   <source>Confirm copied element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>Confirmar elemento copiado</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>El elemento seleccionado cuenta y se guarda desde ahora (al editar: Intro)</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Regularizar</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>Volver a muestrear el elemento a lo largo de su línea pintada: dos clics hacen un elemento recto, cinco una curva</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Cerrar huecos</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>Llevar los extremos del elemento hasta la esquina o el borde de la imagen que no alcanzan</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Invertir</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>Dar la vuelta al orden de los puntos del elemento</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Duplicar a la clase simétrica</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>Poner una copia con la clase del campo girado, para arrastrarla a su sitio</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Ajustarse a las líneas</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click beside it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>Los clics cerca de una línea pintada van a su centro (mantener Ctrl para marcar al lado)</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Pasar al elemento siguiente</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>Tras terminar un elemento, elegir el que más probablemente sigue</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>Dos clics terminan un elemento recto</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>El segundo clic en un elemento recto lo termina</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Dibujar primero, nombrar después</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>Sin elemento elegido, un clic empieza una línea; una vez terminada, se ofrecen junto al lápiz los elementos más probables</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Fijar elementos</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>Solo se pueden arrastrar puntos, no elementos enteros</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>Fantasmas</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Fantasma siguiente</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>Mirar de cerca el próximo elemento que espera la cámara ajustada</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Fantasma anterior</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>Mirar de cerca el anterior</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Aceptar fantasma</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>Hacer del fantasma un elemento: puntos sobre su línea pintada, ninguno donde está oculta (Intro)</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Aceptar todos los fantasmas</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>Aceptar todos los fantasmas cuyas líneas pintadas se ven lo bastante bien (Mayús+Intro mientras no se dibuja nada)</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Parte visible para aceptar todos…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>Cuánto de su línea pintada debe verse para aceptar un fantasma junto con los demás</translation>
  </message>
  <message>
   <source>The ghost, or the chosen element, cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>El fantasma, o el elemento elegido, no se ve en esta imagen; otra vez lo retira</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>Retirar «no visible aquí»</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>El elemento que se dio en último lugar por no visible en esta imagen quizá se vea</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Mostrar fantasmas</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>Dibujar curvas tenues donde la cámara ajustada espera elementos aún no anotados</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Buscar la cámara en la imagen</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>Donde aún no hay nada anotado, hallar la cámara sin un clic y mostrar sus elementos como fantasmas; nada se guarda antes de aceptarlo</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Decir qué anotar a continuación</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>Marcar en el mapa del campo el elemento que más seguridad daría a la cámara ajustada</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Ajustar a la ventana</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>Mostrar toda la imagen</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Tamaño real</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>Un píxel de la imagen es un píxel de la pantalla</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Acercar</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>Ampliar (la rueda del ratón lo hace en el cursor)</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Alejar</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>Reducir (la rueda del ratón lo hace en el cursor)</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>Desplazar</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>El botón izquierdo mueve la imagen (o mantener Espacio, o el botón central); Esc lo termina</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Mantener el zoom entre imágenes</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>Quedarse en este lugar al cambiar de imagen</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Ocultar superposiciones</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>Mostrar la imagen sola (o mantener X)</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>Colorear por</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>Criterio</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>Los colores dicen cómo se juzga la cámara</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>Clase</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>Cada elemento en su propio color</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>Procedencia</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>Puntos según cómo surgieron: marcados, ajustados, regularizados, copiados, movidos</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>Anotador</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>Puntos según quién los puso</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Anchura pintada</translation>
  </message>
  <message>
   <source>Draw how wide the paint of the field's lines must appear, beside the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>Dibujar junto a la proyección qué ancho debe tener la pintura de las líneas del campo</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Indicios de pintura</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>Junto a cada tramo una tira: continua donde la imagen muestra pintura debajo, discontinua donde la pintura pasa al lado, en ese lado, punteada donde no hay</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Lupa</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>Mantener la lupa en el cursor (o mantener Z; también aparece al arrastrar un punto)</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>Girar el mapa hacia la cámara</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint; the half that is out of sight leaves its room to the other one</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>El mapa tiene abajo el lado en que está la cámara, y lo que esta no ve es tenue; la mitad fuera de vista deja su sitio a la otra</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Tira de imágenes</translation>
  </message>
  <message>
   <source>Below the picture: of a video, or of frames that follow one another, how their cameras do and where they are annotated; of other frames small pictures with their states</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>Bajo la imagen: en un vídeo o en imágenes seguidas, cómo van sus cámaras y dónde están anotadas; en otras, miniaturas con su estado</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set as plots, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>Errores y JaC de la imagen o del conjunto como gráficos, de todas las fuentes mostradas</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Paneles para anotar</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>Elementos, hallazgos de la revisión, puntos de referencia</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Paneles para juzgar</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>Puntuaciones, fuentes de cámaras, ajuste, gráficos</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Paneles para revisar</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>Estado, comentarios y tiempo, un segundo anotador</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Ocultar todos los paneles</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>Dar todo el espacio a la imagen</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>Teclado a los paneles</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>En la imagen, Tab recorre los fantasmas; esto lleva el teclado a los paneles</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Teclado a la parte siguiente</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>Imagen, paneles, barras: el teclado las recorre</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>Teclado a la parte anterior</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>El mismo recorrido al revés</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Restablecer la disposición</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>Volver a poner los paneles donde estaban al principio</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Cargar cámaras…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>Juzgar una carpeta de cámaras u homografías con las anotaciones</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Cargar archivo de cámara…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>Juzgar un solo archivo de cámara, o un zip de ellos</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Siguiente fuente de cámaras</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>Juzgar con la siguiente de las fuentes cargadas</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Anterior fuente de cámaras</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>Juzgar con la anterior</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Intercambiar con la fuente comparada</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>Juzgar con la fuente comparada y comparar con esta (o pulsar la coma; mantenerla solo para mirar)</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>Dibujar otras fuentes</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes beside the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>Dibujar las fuentes marcadas en el panel Cámaras como armazones junto a la activa</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>Vista dividida</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>Dibujar la fuente activa a la izquierda de un divisor y la comparada a la derecha</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>Desacuerdo</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>A cuántos metros ven la fuente activa y la comparada cada píxel sobre el suelo</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Mapa de incertidumbre</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>Dónde del campo la cámara ajustada acierta hasta 0.1, 0.5 y 1 m</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajuste continuo</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>Ajustar una cámara a los clics de la imagen tras cada cambio</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Guardar el ajuste como cámara de la imagen</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>Escribir la cámara ajustada a los clics en la carpeta cameras/fitted del conjunto</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Dimensiones del campo…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>Longitud y anchura del campo de este estadio, introducidas o halladas con todas las imágenes; y en qué parte de sus líneas están los clics</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Umbral: 0.5 px más</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>Permitir distancias mayores</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Umbral: 0.5 px menos</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>Permitir solo distancias menores</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[the menus, the setting protocol]</extracomment>
   <translation>Protocolo</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>La evaluación oficial de SoccerNet, con sus rarezas</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>La definición del artículo, sin los artefactos del código oficial</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>Elementos fuera del suelo</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>Contar como fallados</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>Las porterías, canastas y redes que una homografía no puede proyectar cuentan en su contra</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>Dejar fuera</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>Las porterías, canastas y redes que una homografía no puede proyectar no se cuentan</translation>
  </message>
  <message>
   <source>Camera fault</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>Fallo de la cámara</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>La cámara activa está mal en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>Annotation fault</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Fallo de la anotación</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>Los clics están mal en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>Fine</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>Correcto</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>La cámara y los clics están bien en esta imagen; otra vez retira el veredicto</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Nota al veredicto…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>Decir en pocas palabras qué está mal; se exporta con el veredicto</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Detener la puntuación del conjunto</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>Dejar de calcular el JaC de las imágenes aún no abiertas y de comparar fuentes</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>Buscar lo que sea…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>La paleta de órdenes: toda acción, elemento, imagen, fuente de cámaras y carpeta reciente, con unas letras de su nombre</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>Mostrar todas las acciones y sus teclas en una hoja</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>Dar otras teclas a acciones y elementos, o tomar las de otro programa</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>La guía que trae el programa; no necesita red</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>Versión</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>Aspecto</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Tema</translation>
  </message>
  <message>
   <source>Light, dark, or as the system has it</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Claro, oscuro, o como el sistema</translation>
  </message>
  <message>
   <source>As the system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Como el sistema</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Claro</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>Oscuro</translation>
  </message>
  <message>
   <source>Size of texts</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Tamaño de los textos</translation>
  </message>
  <message>
   <source>How large texts are, of what the system says; from the next start on</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>Lo grandes que son los textos respecto a lo que dice el sistema; desde el próximo inicio</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>Idioma</translation>
  </message>
  <message>
   <source>The language of the window; from the next start on. Files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>El idioma de la ventana; desde el próximo inicio. Los archivos quedan como están</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>Lo que dicen los colores sobre la imagen</translation>
  </message>
  <message>
   <source>Your name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>Su nombre</translation>
  </message>
  <message>
   <source>Whose name points, comments and versions bear; empty: that of the system's user</source>
   <extracomment>[the setting author]</extracomment>
   <translation>El nombre que llevan puntos, comentarios y versiones; vacío: el del usuario del sistema</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>Evaluación</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>Umbral</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>A qué distancia de su elemento puede estar un punto anotado, en px del tamaño de evaluación</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>Cómo se juzgan las cámaras: como la evaluación oficial, con sus rarezas, o según la definición del artículo</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>soccernet (oficial)</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc (artículo)</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>Cómo cuentan los elementos que una homografía no puede proyectar: porterías, canastas, redes</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>Modelo del ajuste continuo</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>La cámara que se ajusta a los clics; auto: la más sencilla que permiten</translation>
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
   <translation>Juzgar el ajuste</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>Si se juzga el ajuste donde no hay otra cosa</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Parte visible para aceptar todos</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>Cuánto de la línea de un fantasma debe verse para aceptarlo con todos los demás</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Fútbol americano (NFL)</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea lateral cercana</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea lateral lejana</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marcas hash cercanas</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marcas hash lejanas</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Línea de gol izquierda</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 5 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 10 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 15 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 20 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 25 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 30 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 35 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 40 yardas izquierda</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 45 yardas izquierda</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 50 yardas</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Línea de gol derecha</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 5 yardas derecha</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 10 yardas derecha</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 15 yardas derecha</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 20 yardas derecha</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 25 yardas derecha</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 30 yardas derecha</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 35 yardas derecha</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 40 yardas derecha</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Línea de 45 yardas derecha</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Travesaño izquierdo</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería izquierda, poste izquierdo</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería izquierda, poste derecho</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Travesaño derecho</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería derecha, poste izquierdo</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Portería derecha, poste derecho</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marca de conversión izquierda</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Marca de conversión derecha</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longitud con ambas zonas de anotación</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Profundidad de una zona de anotación</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Yarda</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De la línea de yarda a la lateral</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De las marcas hash a la lateral</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>De la marca de conversión a la línea de gol</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Longitud de la marca de conversión</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Anchura de la portería</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Altura del travesaño</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Postes sobre el travesaño</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>Anchura de las líneas</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Anchura de la línea de gol</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Anchura del borde</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Mitad izquierda</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>Mitad derecha</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>Portería derecha</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Atletismo (pista de 400 m)</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Bordillo</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calle 8, borde exterior</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calle 9, borde exterior</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de meta</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 100 m</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 110 m vallas</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 3000 m y 5000 m</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 10 000 m</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Línea de calle libre</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 200 m, calle 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 400 m, calle 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salida de 800 m, calle 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta, línea interior</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad, línea 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Longitud con ocho calles</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Anchura con ocho calles</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Anchura de calle</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Calles</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Meta y salidas</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 200 m</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 400 m</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Salidas de 800 m</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>Recta de velocidad</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Baloncesto (FIBA)</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea central</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Círculo central</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea de tiros libres izquierda</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de tiros libres izquierdo</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha, lado lejano</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Línea de tiros libres derecha</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de tiros libres derecho</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arco de tres puntos izquierdo</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos izquierda, recta lejana</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos izquierda, recta cercana</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Arco de tres puntos derecho</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos derecha, recta lejana</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tres puntos derecha, recta cercana</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tablero izquierdo</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Aro izquierdo</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de no carga izquierdo</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Tablero derecho</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Aro derecho</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Semicírculo de no carga derecho</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectángulo del tablero izquierdo</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centro del aro izquierdo</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Rectángulo del tablero derecho</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Centro del aro derecho</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>Longitud</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Línea central más allá de las laterales</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>Radio del círculo</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Longitud de la zona</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura de la zona</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radio de tres puntos</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>De la línea de tres puntos a la lateral</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>Radio de no carga</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Del tablero a la línea de fondo</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura del tablero</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del tablero</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Borde inferior del tablero</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Anchura del rectángulo del tablero</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del rectángulo del tablero</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Altura del aro</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Radio del aro</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Del aro al tablero</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>Pista</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona izquierda</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Zona derecha</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de tres puntos izquierda</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Línea de tres puntos derecha</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Canasta izquierda</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>Canasta derecha</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Baloncesto (NBA)</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo de tiros libres izquierdo</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo de tiros libres derecho</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arco de zona restringida izquierdo</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Arco de zona restringida derecho</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Círculo central interior</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash lejana izquierda</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash lejana derecha</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash cercana izquierda</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Marca hash cercana derecha</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radio del círculo interior</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Radio de la zona restringida</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>De la marca hash a la línea de fondo</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>Longitud de la marca hash</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Fútbol sala</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de banda cercana</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de banda lejana</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Línea de medio campo</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Línea del área izquierda</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Línea del área derecha</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda, poste lejano</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería izquierda, poste cercano</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería derecha, poste lejano</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>Portería derecha, poste cercano</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto central</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto de penalti izquierdo</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Segundo punto de penalti izquierdo</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Punto de penalti derecho</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Segundo punto de penalti derecho</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina lejano izquierdo</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina cercano izquierdo</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina lejano derecho</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Arco de esquina cercano derecho</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, izquierda exterior</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, izquierda interior</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, derecha interior</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución lejana, derecha exterior</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, izquierda exterior</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, izquierda interior</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, derecha interior</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zona de sustitución cercana, derecha exterior</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Anchura de los postes</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radio del área de penalti</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Del punto de penalti a la línea de meta</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Del segundo punto de penalti a la línea de meta</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Radio del círculo central</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Radio de los arcos de esquina</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>Altura de la portería</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Terreno</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Área de penalti izquierda</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Área de penalti derecha</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Marcas</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>Esquinas</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>Zonas de sustitución</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Balonmano</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Línea lateral cercana</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>Línea lateral lejana</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Zona de saque inicial</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea del área de portería izquierda</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 7 metros izquierda</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 4 metros izquierda</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea del área de portería derecha</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 7 metros derecha</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de 4 metros derecha</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio lejana, izquierda</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio lejana, derecha</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio cercana, izquierda</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Línea de cambio cercana, derecha</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radio del área de portería</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Radio de la línea de golpe franco</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Área de portería izquierda</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>Área de portería derecha</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>Líneas de cambio</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>Hockey sobre hielo (IIHF)</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla lateral cercana</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla lateral lejana</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla de fondo izquierda</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Valla de fondo derecha</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina cercana izquierda</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina lejana izquierda</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina cercana derecha</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Esquina lejana derecha</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Línea azul izquierda</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Línea azul derecha</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo cercano derecho</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculo lejano derecho</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Área de portería izquierda</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería izquierda, poste izquierdo</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería izquierda, poste derecho</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Área de portería derecha</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería derecha, poste izquierdo</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>Portería derecha, poste derecho</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio izquierdo, cercano</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio izquierdo, lejano</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio derecho, cercano</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio derecho, lejano</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zona del árbitro, cercana</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Zona del árbitro, lejana</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto central</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona cercano derecho</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto de zona lejano derecho</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral cercano izquierdo</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral lejano izquierdo</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral cercano derecho</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Punto neutral lejano derecho</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla cercana</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla lejana</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla izquierda</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la valla derecha</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina cercana izquierda</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina lejana izquierda</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina cercana derecha</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de la esquina lejana derecha</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de las esquinas</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Altura de la valla</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>De la línea de gol a la valla de fondo</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>De la línea azul a la valla de fondo</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de los círculos de saque</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto de zona a la línea de gol</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto neutral a la línea azul</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Del punto al eje longitudinal</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio del área de portería</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Anchura del área de portería</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Radio de la zona del árbitro</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio en la línea de gol</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Trapecio en la valla de fondo</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Anchura de las líneas azules y central</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Vallas</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Líneas</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Círculos de saque</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Puntos de saque</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>Borde superior de las vallas</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>Hockey sobre hielo (NHL)</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>De la línea azul a la línea de gol</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Fútbol</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, frente</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, frente</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área grande derecha, lado lejano</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Semicírculo del área izquierda</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Semicírculo del área derecha</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña izquierda, lado cercano</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña izquierda, frente</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña izquierda, lado lejano</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña derecha, lado cercano</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña derecha, frente</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Área pequeña derecha, lado lejano</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín lejano izquierdo (pie)</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín cercano izquierdo (pie)</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín lejano derecho (pie)</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Banderín cercano derecho (pie)</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profundidad del área grande</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Anchura del área grande</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Profundidad del área pequeña</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Anchura del área pequeña</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Portería desconocida</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>Línea desconocida</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Tenis</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de fondo izquierda</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de fondo derecha</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de dobles lejana</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de dobles cercana</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de individuales lejana</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Lateral de individuales cercana</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de servicio izquierda</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea de servicio derecha</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Línea central de servicio</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Borde superior de la red</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poste de red lejano</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Poste de red cercano</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Faja central de la red</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Palo de individuales lejano</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Palo de individuales cercano</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marca central izquierda</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Marca central derecha</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de individuales</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>De la línea de servicio a la red</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de la línea de fondo</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Anchura de la línea central</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Longitud de la marca central</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en la faja</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en los postes</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Altura de la red en los palos de individuales</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Del poste de red a la lateral</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>Cuadros de servicio</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>Red</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Voleibol</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Línea de ataque izquierda</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Línea de ataque derecha</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Banda superior de la red</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Banda inferior de la red</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena lejana</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena cercana</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poste lejano</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Poste cercano</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación lejana izquierda</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación cercana izquierda</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación lejana derecha</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación cercana derecha</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque lejana izquierda</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque cercana izquierda</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque lejana derecha</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marca de saque cercana derecha</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>De la línea de ataque a la central</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Altura de la red</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Ancho de la malla</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longitud de la red</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Antena sobre la red</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Del poste a la lateral</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Altura de los postes</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Prolongación de la línea de ataque</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>De la marca de saque a la línea de fondo</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Longitud de la marca de saque</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>Marcas fuera de la pista</translation>
  </message>
 </context>
</TS>
