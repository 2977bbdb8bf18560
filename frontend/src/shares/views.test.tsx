import { screen, waitFor } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { answer, wrote } from '@/test/server'
import { aCue, ListServer } from '@/test/soundList'

test('a filter is kept under a name, and opens the list as it was', async () => {
  const server = new ListServer([aCue(1, 'ui_confirm', { category: 'ui' }), aCue(2, 'shield_hit')])
  const views = [{ id: 'v1', page: 'sound_list', name: 'Interface', query: 'category=ui&unclear=true' }]
  server.answers[`GET ${server.at}/saved-views`] = views
  server.answers[`POST ${server.at}/saved-views`] = answer({ ...views[0], id: 'v2', name: 'Weapons' }, 201)
  server.answers['DELETE /v1/saved-views/v1'] = answer(null, 204)
  const app = openApp(`${server.path}?category=weapon`)
  await screen.findByRole('row', { name: /shield_hit/ })
  await userEvent.click(screen.getByRole('button', { name: 'Display' }))
  await userEvent.click(screen.getByRole('button', { name: 'Views' }))
  await userEvent.type(await screen.findByLabelText('Name of the view'), 'Weapons')
  await userEvent.click(screen.getByRole('button', { name: 'Save view' }))
  await waitFor(() => expect(wrote(server.asked, `POST ${server.at}/saved-views`)).toHaveLength(1))
  expect(wrote(server.asked, `POST ${server.at}/saved-views`)[0]?.body).toEqual({
    page: 'sound_list',
    name: 'Weapons',
    query: 'category=weapon',
  })
  await userEvent.click(screen.getByRole('menuitem', { name: 'Delete Interface' }))
  await waitFor(() => expect(wrote(server.asked, 'DELETE /v1/saved-views/v1')).toHaveLength(1))
  await userEvent.click(screen.getByRole('menuitem', { name: 'Interface' }))
  await waitFor(() => expect(app.search()).toEqual({ category: 'ui', unclear: true }))
})
