import { screen } from '@testing-library/react'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import checks from '@/test/checks.json'
import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { serve } from '@/test/server'

test('each check of the server is a line of the form, and axe finds nothing', { tags: ['slow'] }, async () => {
  serve(inProject())
  openApp('/projects/p1/spec?view=all')
  expect(await screen.findByLabelText('True peak, dBTP')).toHaveValue('−1')
  const withSeverity = checks.filter(({ limits }) => limits.every(({ usual }) => usual !== null))
  const labels = [
    ...checks.flatMap(({ limits }) => limits.filter(({ usual }) => usual === null)),
    ...withSeverity.filter(({ limits }) => limits.length === 0),
  ].map(({ label }) => `${label}: result`)
  const groups = [...document.querySelectorAll('[role="group"][aria-label$=": result"]')]
  expect(groups.map((group) => group.getAttribute('aria-label')).toSorted()).toEqual(labels.toSorted())
  const { violations } = await axe.run(document.body, {
    rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
  })
  expect(violations.map(({ id }) => id)).toEqual([])
})
