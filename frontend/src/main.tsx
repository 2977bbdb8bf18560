import './app/mantineStyles'
import './app/tokens.css'
import './app/base.css'
import './app/utilities.css'
import './app/mantine.css'

import { StrictMode } from 'react'
import { createRoot } from 'react-dom/client'

import { queryClient } from './api/queryClient'
import { App } from './app/App'
import { router } from './app/router'
import { prefetchPage } from './app/prefetchPage'

const place = document.getElementById('root')
if (place === null) throw new Error('index.html has no #root')

prefetchPage(router, queryClient, router.options.context.session)
createRoot(place).render(
  <StrictMode>
    <App />
  </StrictMode>,
)
